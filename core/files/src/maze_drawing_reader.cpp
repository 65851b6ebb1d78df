#include <algorithm>
#include <optional>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "maze_formats.hpp"
#include "maze_layout.hpp"
#include "object_kinds.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

struct Row {
  std::string_view text;   ///< Two columns a cell.
  std::string_view drawn;  ///< As it stands in the file.
  int line = 0;
};

/// Columns that every cell of a drawing takes, with the grid line to its left.
constexpr std::size_t kUsualPitch = 2;
constexpr std::size_t kWidePitch = 3;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Facing of a start letter, radians; nothing for other characters.
std::optional<double> facing(char letter) {
  return letter == 'S' || letter == 's' ? kPi / 2 : facing_of(letter);
}

bool is_object(char c) { return c == 'o' || c == 'O' || c == 'x' || c == 'X'; }
bool is_goal(char c) { return c == 'g' || c == 'G'; }
/// True for letters that put something into the maze.
bool is_sign(char c) { return is_object(c) || is_goal(c) || facing(c).has_value(); }

class MazeReader {
 public:
  explicit MazeReader(const MazeSource& source)
      : file_(source.file),
        warnings_(source.file, source.warnings),
        start_places_(source.start_places),
        cell_(source.cell) {
    for (const MazeLine& line : maze_lines(source.bytes, file_)) {
      rows_.push_back({line.text, line.text, line.line});
    }
  }

  world::WorldModel read() {
    take_size();
    if (is_wide()) narrow();
    lay_out_grid();
    if (cell_) grid_.cell = *cell_;
    for (std::size_t r = 0; r < rows_.size(); ++r) read_row(r);
    sort_goals(grid_);
    model_.width = grid_.columns * grid_.cell;
    model_.height = grid_.rows * grid_.cell;
    model_.walls = world::walls_of(grid_);
    if (model_.walls.empty()) {
      throw ConfigError({file_, rows_.front().line, 1},
                        "no wall in the maze: expected '|' in odd and '_' in even columns");
    }
    warn_of_gaps(grid_, warnings_,
                 [this](world::MazeCell cell, Side side) { return place_of(cell, side); });
    model_.maze = std::move(grid_);
    return std::move(model_);
  }

 private:
  void drop_empty_front() {
    rows_.erase(rows_.begin(), std::find_if(rows_.begin(), rows_.end(),
                                            [](const Row& row) { return !row.text.empty(); }));
  }

  std::optional<double> size_in(const Row& row) {
    return cell_size_in({row.text, row.line}, file_);
  }

  void take_size() {
    if (!rows_.empty()) {
      if (const auto size = size_in(rows_.back())) {
        grid_.cell = *size;
        rows_.pop_back();
      }
    }
    while (!rows_.empty() && rows_.back().text.empty()) rows_.pop_back();
    if (rows_.empty()) {
      throw ConfigError({file_, 1, 1}, "no maze in the file: expected one drawn with '|' and '_'");
    }
    if (const auto size = size_in(rows_.front())) {
      warnings_.add(rows_.front().line, 1,
                    "the size of a cell stands on the first line: expected it on the last");
      grid_.cell = *size;
      rows_.erase(rows_.begin());
      drop_empty_front();
    }
  }

  /// True for a maze drawn with three columns a cell: "|__|" where others draw "|_|".
  bool is_wide() const {
    bool bar_off_the_usual_grid = false;
    for (const Row& row : rows_) {
      const std::string_view text = row.text;
      const auto at = [&](std::size_t i) { return i < text.size() ? text[i] : ' '; };
      for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '|') {
          if (i % kWidePitch != 0) return false;
          bar_off_the_usual_grid = bar_off_the_usual_grid || i % kUsualPitch != 0;
        }
        if (text[i] == '\t') return false;
        // A wall below a cell takes both of its columns, unless something stands in one of them.
        if (i % kWidePitch == 1 && (at(i) == '_') != (at(i + 1) == '_') && !is_letter(at(i)) &&
            !is_letter(at(i + 1))) {
          return false;
        }
      }
    }
    return bar_off_the_usual_grid;
  }

  /// Turns a wide drawing into the usual one, whose lines are kept in narrow_.
  void narrow() {
    pitch_ = kWidePitch;
    warnings_.add(rows_.front().line, 1,
                  "drawn with three columns a cell: read as such, though two are usual");
    narrow_.reserve(rows_.size());
    for (Row& row : rows_) {
      std::string line;
      for (std::size_t i = 0; i < row.text.size(); ++i) {
        const char c = row.text[i];
        if (i % kWidePitch < 2) {
          line += c;
        } else if (is_letter(c) && !is_letter(line.back())) {
          line.back() = line.back() == '_' ? upper(c) : c;
        } else if (c == '_' && is_letter(line.back())) {
          line.back() = upper(line.back());
        } else if (line.back() == ' ') {
          line.back() = c;
        } else if (c != ' ' && c != line.back()) {
          warnings_.add(row.line, static_cast<int>(i) + 1,
                        std::string("'")
                            .append(1, c)
                            .append("' beside '")
                            .append(1, line.back())
                            .append("' in the same cell is ignored: expected one of them"));
        }
      }
      row.text = narrow_.emplace_back(std::move(line));
    }
  }

  void lay_out_grid() {
    std::size_t longest = 0;
    for (const Row& row : rows_) longest = std::max(longest, row.text.size());
    const std::size_t columns = longest / 2;
    const SourceLocation where{file_, rows_.empty() ? 1 : rows_.front().line, 1};
    if (rows_.size() < 2 || columns == 0) {
      throw ConfigError(where,
                        "no cell in the maze: expected at least two lines of two columns drawn "
                        "with '|' and '_'");
    }
    const double cell = grid_.cell;
    grid_ = empty_maze(columns, rows_.size() - 1, where);
    grid_.cell = cell;
  }

  void read_row(std::size_t r) {
    const std::string_view text = rows_[r].text;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const char c = text[i];
      if (c == ' ') continue;
      if (c == '|') {
        read_bar(r, i);
      } else if (c == '_') {
        read_dash(r, i);
      } else if (facing(c)) {
        add_start(r, i);
      } else if (is_object(c)) {
        add_object(r, i);
      } else if (is_goal(c)) {
        add_goal(r, i);
      } else if (c == '\t') {
        throw ConfigError({file_, rows_[r].line, column(r, i)},
                          "tab found: expected blanks, a tab has no width in a drawing");
      } else if (static_cast<unsigned char>(c) >= 0x80) {
        if (!told_of_bytes_)
          odd(r, i, "character outside ASCII: it may shift the columns after it");
        told_of_bytes_ = true;
      } else if (c != '.') {  // a dot keeps a column that would be lost at the end of a line
        odd(r, i, "'" + std::string(1, c) + "' means nothing in a maze and is ignored");
      }
    }
  }

  void read_bar(std::size_t r, std::size_t i) {
    if (r == 0) return odd(r, i, "'|' above the top boundary is ignored");
    if (i % 2 != 0) {
      if (has_sign(r, i + 1)) return odd(r, i, no_room("'|' in an even column", r, i + 1));
      odd(r, i,
          "'|' in an even column, taken for one in the column after it: walls stand in odd "
          "columns");
    }
    grid_.west[(row(r)) * (width() + 1) + (i + 1) / 2] = 1;
  }

  void read_dash(std::size_t r, std::size_t i) {
    if (i % 2 == 1) return put_floor(r, i);
    // In odd columns underscores only join those of the cells beside them.
    const std::string_view text = rows_[r].text;
    const bool joined = (i > 0 && (text[i - 1] == '_' || is_upper(text[i - 1]))) ||
                        (i + 1 < text.size() && (text[i + 1] == '_' || is_upper(text[i + 1])));
    if (joined) return;
    if (i == 0) return odd(r, i, "'_' in the first column is ignored: it belongs into an even one");
    if (has_sign(r, i - 1)) return odd(r, i, no_room("'_' in an odd column", r, i - 1));
    odd(r, i,
        "'_' in an odd column, taken for one in the column before it: it belongs into an even one");
    put_floor(r, i - 1);
  }

  bool has_sign(std::size_t r, std::size_t i) const {
    const std::string_view text = rows_[r].text;
    return i < text.size() && is_sign(text[i]);
  }
  std::string no_room(const char* wall, std::size_t r, std::size_t i) const {
    return std::string(wall) + " is ignored: '" + rows_[r].text[i] + "' stands where it belongs";
  }

  /// The wall under the character at even column `i` + 1 of line `r`; line 0 is the top boundary.
  void put_floor(std::size_t r, std::size_t i) {
    const std::size_t boundary = static_cast<std::size_t>(grid_.rows) - r;
    grid_.south[boundary * width() + i / 2] = 1;
  }

  /// Pose of what is drawn at line `r`, index `i`; even columns are cell centres.
  Pose place(std::size_t r, std::size_t i) const {
    const double half = grid_.cell / 2;
    return {static_cast<double>(i) * half, static_cast<double>(2 * row(r) + 1) * half, 0};
  }

  bool stands_in_cell(std::size_t r, std::size_t i, const std::string& what) {
    if (r == 0) {
      odd(r, i, what + " above the top boundary is ignored");
      return false;
    }
    if (i % 2 == 1) {
      if (is_upper(rows_[r].text[i])) put_floor(r, i);
    } else {
      odd(r, i, what + " stands on a grid line, not in a cell: cells are even columns");
    }
    return true;
  }

  void add_start(std::size_t r, std::size_t i) {
    const char letter = rows_[r].text[i];
    if (!stands_in_cell(r, i, std::string("start '") + letter + "'")) return;
    Pose pose = place(r, i);
    pose.theta = *facing(letter);
    model_.starts.push_back({letter, pose});
    if (start_places_ != nullptr) {
      start_places_->push_back({file_, rows_[r].line, column(r, i)});
    }
  }

  void add_goal(std::size_t r, std::size_t i) {
    if (!stands_in_cell(r, i, std::string("goal '") + rows_[r].text[i] + "'")) return;
    if (i % 2 == 0) return;  // on a line between two cells
    grid_.goals.push_back({static_cast<int>(i / 2), static_cast<int>(row(r))});
  }

  void add_object(std::size_t r, std::size_t i) {
    const char c = rows_[r].text[i];
    const bool ball = c == 'o' || c == 'O';
    if (!stands_in_cell(r, i, ball ? "golf ball" : "crate")) return;
    world::ObjectSpec object = builtin_object(ball ? "golf" : "crate").value();
    object.radius = std::min(object.radius, 0.4 * grid_.cell);
    if (ball) object.height = 2 * object.radius;
    object.pose = place(r, i);
    model_.objects.push_back(object);
  }

  /// Where an edge of a cell is drawn.
  [[nodiscard]] SourceLocation place_of(world::MazeCell cell, Side side) const {
    const auto line =
        static_cast<std::size_t>(grid_.rows - cell.row - (side == Side::North ? 1 : 0));
    const auto at = 2 * static_cast<std::size_t>(cell.column) + (side == Side::West   ? 0
                                                                 : side == Side::East ? 2
                                                                                      : 1);
    return {file_, rows_[line].line,
            static_cast<int>(at / kUsualPitch * pitch_ + at % kUsualPitch) + 1};
  }

  void odd(std::size_t r, std::size_t i, const std::string& text) {
    warnings_.add(rows_[r].line, column(r, i), text);
  }
  /// Column in the file of what stands at line `r`, index `i`.
  int column(std::size_t r, std::size_t i) const {
    std::size_t at = i / kUsualPitch * pitch_ + i % kUsualPitch;
    const std::string_view drawn = rows_[r].drawn;
    if (pitch_ == kWidePitch && i % kUsualPitch == 1 && !is_letter(drawn[at]) &&
        at + 1 < drawn.size() && is_letter(drawn[at + 1])) {
      ++at;  // the letter stands in the second column of its cell
    }
    return static_cast<int>(at) + 1;
  }
  std::size_t width() const { return static_cast<std::size_t>(grid_.columns); }
  /// Grid row, counted from below, of line `r` >= 1.
  std::size_t row(std::size_t r) const { return static_cast<std::size_t>(grid_.rows) - r; }

  const std::string& file_;
  Warnings warnings_;
  std::vector<SourceLocation>* start_places_;
  std::optional<double> cell_;
  std::vector<Row> rows_;
  std::vector<std::string> narrow_;  ///< Lines of a wide drawing, in the usual width.
  std::size_t pitch_ = kUsualPitch;
  world::MazeGrid grid_;
  world::WorldModel model_;
  bool told_of_bytes_ = false;
};

}  // namespace

world::WorldModel read_drawn_maze(const MazeSource& source) { return MazeReader(source).read(); }

}  // namespace eyebridge::files
