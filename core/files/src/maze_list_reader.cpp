#include <algorithm>
#include <array>
#include <utility>

#include "maze_formats.hpp"
#include "maze_layout.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

using world::MazeCell;

constexpr std::size_t kWords = 6;
constexpr int kMostIndex = 32767;
constexpr const char* kListForm = "x y north east south west";

/// One line of the list.
struct ListedCell {
  MazeCell at;
  std::array<bool, 4> walls{};  ///< As kSides.
  int line = 0;
};

class ListReader {
 public:
  explicit ListReader(const MazeSource& source)
      : source_(source), file_(source.file), warnings_(source.file, source.warnings) {}

  world::WorldModel read() {
    read_cells();
    const auto grid_columns = static_cast<std::size_t>(columns_) + 1;
    const auto grid_rows = static_cast<std::size_t>(rows_) + 1;
    grid_ = empty_maze(grid_columns, grid_rows, {file_, cells_.front().line, 1});
    grid_.cell = source_.cell.value_or(kContestCell);
    lines_.assign(grid_columns * grid_rows, 0);
    for (const ListedCell& cell : cells_) put(cell);
    check_all_there();
    for (const ListedCell& cell : cells_) check_neighbours(cell);
    warn_of_gaps(grid_, warnings_, [this](MazeCell cell, Side side) {
      return SourceLocation{file_, line_of(cell), column_of(side)};
    });
    if (source_.start_places != nullptr) source_.start_places->push_back({file_, 0, 0});
    return contest_maze(std::move(grid_), {});
  }

 private:
  void read_cells() {
    StatementReader statements(source_.bytes, file_);
    Statement line;
    while (statements.next(line)) {
      if (line.size() != kWords) {
        line.fail(std::min(line.size(), kWords),
                  std::to_string(line.size()) + " words on a line: expected '" + kListForm + "'");
      }
      ListedCell cell;
      cell.line = line.line();
      cell.at = {line.integer(0, "x", 0, kMostIndex), line.integer(1, "y", 0, kMostIndex)};
      constexpr const char* kNames[] = {"north", "east", "south", "west"};
      for (std::size_t i = 0; i < cell.walls.size(); ++i) {
        cell.walls[i] = line.integer(i + 2, std::string("wall ") + kNames[i], 0, 1) == 1;
      }
      columns_ = std::max(columns_, cell.at.column);
      rows_ = std::max(rows_, cell.at.row);
      cells_.push_back(cell);
    }
  }

  int& line_of(MazeCell cell) {
    return lines_[static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(grid_.columns) +
                  static_cast<std::size_t>(cell.column)];
  }

  void put(const ListedCell& cell) {
    int& line = line_of(cell.at);
    if (line != 0) {
      throw ConfigError({file_, cell.line, 1}, "cell " + in_words(cell.at) + " again, after line " +
                                                   std::to_string(line) + ": expected it once");
    }
    line = cell.line;
    for (std::size_t i = 0; i < cell.walls.size(); ++i) {
      if (cell.walls[i]) edge(grid_, cell.at, kSides[i]) = 1;
    }
  }

  void check_all_there() {
    for (int column = 0; column < grid_.columns; ++column) {
      for (int row = 0; row < grid_.rows; ++row) {
        if (line_of({column, row}) != 0) continue;
        throw ConfigError({file_, cells_.back().line + 1, 1},
                          "file ends without cell " + in_words(world::MazeCell{column, row}) +
                              ": expected all " + std::to_string(grid_.columns) + " x " +
                              std::to_string(grid_.rows));
      }
    }
  }

  /// A wall that only one of its two cells has is there, with a warning.
  void check_neighbours(const ListedCell& cell) {
    for (std::size_t i = 0; i < cell.walls.size(); ++i) {
      if (cell.walls[i] || !has_wall(grid_, cell.at, kSides[i])) continue;
      warnings_.add(cell.line, column_of(kSides[i]),
                    "no wall on this side of cell " + in_words(cell.at) +
                        ", but its neighbour has one: there is a wall");
    }
  }

  /// Where the flag of a side stands on a line whose words are digits with one blank between them.
  static int column_of(Side side) { return static_cast<int>(2 * (2 + static_cast<int>(side)) + 1); }
  const MazeSource& source_;
  const std::string& file_;
  Warnings warnings_;
  std::vector<ListedCell> cells_;
  std::vector<int> lines_;  ///< Of each cell; 0: it has none.
  int columns_ = 0;
  int rows_ = 0;
  world::MazeGrid grid_;
};

}  // namespace

bool starts_as_list(std::string_view text) {
  const std::string file;
  try {
    StatementReader statements(text.substr(0, text.find('\n', text.find_first_not_of("\r\n \t"))),
                               file);
    Statement line;
    if (!statements.next(line) || line.size() != kWords) return false;
    for (std::size_t i = 0; i < kWords; ++i) {
      if (!line.is_number(i)) return false;
    }
    return true;
  } catch (const ConfigError&) {
    return false;
  }
}

world::WorldModel read_listed_maze(const MazeSource& source) { return ListReader(source).read(); }

}  // namespace eyebridge::files
