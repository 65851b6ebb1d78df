#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "maze_layout.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

using world::MazeCell;

const std::string kWritten = "maze to write";
constexpr double kSame = 1e-9;  ///< Metres, radians.

std::string place_text(const Pose& pose) {
  char text[80];
  std::snprintf(text, sizeof text, "%.7g %.7g mm", m_to_mm(pose.x), m_to_mm(pose.y));
  return text;
}

/// The cell in whose middle something stands.
std::optional<MazeCell> cell_of(const world::MazeGrid& grid, const Pose& pose) {
  const double column = pose.x / grid.cell - 0.5;
  const double row = pose.y / grid.cell - 0.5;
  const MazeCell cell{static_cast<int>(std::lround(column)), static_cast<int>(std::lround(row))};
  const bool is_inside =
      cell.column >= 0 && cell.column < grid.columns && cell.row >= 0 && cell.row < grid.rows;
  if (!is_inside || std::fabs(column - cell.column) > kSame || std::fabs(row - cell.row) > kSame) {
    return std::nullopt;
  }
  return cell;
}

/// The letter of a start that faces along an axis.
std::optional<char> letter_facing(double theta) {
  constexpr std::pair<char, double> kLetters[] = {
      {'U', kPi / 2}, {'D', -kPi / 2}, {'L', kPi}, {'R', 0.0}};
  for (const auto& [letter, angle] : kLetters) {
    if (std::fabs(wrap_angle(theta - angle)) < kSame) return letter;
  }
  return std::nullopt;
}

char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// What no format of mazes can say.
void lose_what_no_maze_has(const world::WorldModel& model, std::vector<std::string>& losses) {
  if (model.floor_texture) losses.push_back("the texture of the floor");
  if (model.water) losses.push_back("the water");
  if (!model.markers.empty()) {
    losses.push_back(std::to_string(model.markers.size()) + " markers");
  }
}

void lose_objects(const world::WorldModel& model, std::vector<std::string>& losses) {
  for (const world::ObjectSpec& object : model.objects) {
    losses.push_back("the " + object.name + " at " + place_text(object.pose));
  }
}

WrittenWorld drawing_of(const world::WorldModel& model) {
  WrittenWorld out;
  world::WorldModel drawn = model;
  lose_what_no_maze_has(model, out.losses);
  drawn.floor_texture.reset();
  drawn.water.reset();
  drawn.markers.clear();
  std::erase_if(drawn.starts, [&](world::StartPose& start) {
    const auto facing = letter_facing(start.pose.theta);
    if (!facing || !cell_of(*model.maze, start.pose)) {
      out.losses.push_back("the start at " + place_text(start.pose));
      return true;
    }
    const bool means_it = letter_facing(start.pose.theta) == capital(start.letter) ||
                          (*facing == 'U' && capital(start.letter) == 'S');
    if (means_it) return false;
    out.losses.push_back("the start '" + std::string(1, start.letter) + "', which is '" +
                         std::string(1, *facing) + "' now, as it faces that way");
    start.letter = *facing;
    return false;
  });
  // A character draws one thing: starts and objects go before goals.
  const auto is_taken = [&](MazeCell goal) {
    const auto stands_there = [&](const Pose& pose) { return cell_of(*model.maze, pose) == goal; };
    return std::ranges::any_of(drawn.starts, stands_there, &world::StartPose::pose) ||
           std::ranges::any_of(drawn.objects, stands_there, &world::ObjectSpec::pose);
  };
  std::erase_if(drawn.maze->goals, [&](MazeCell goal) {
    if (!is_taken(goal)) return false;
    out.losses.push_back("the goal in cell " + in_words(goal));
    return true;
  });
  out.text = write_maze(drawn);
  return out;
}

class PostsDrawing {
 public:
  explicit PostsDrawing(const world::MazeGrid& grid) : grid_(grid) {
    const auto wide = static_cast<std::size_t>(4 * grid.columns + 1);
    if (wide > kMaxLine) {
      throw ConfigError({kWritten, 0, 0}, std::to_string(grid.columns) +
                                              " cells in a row: too many for a line of text");
    }
    lines_.assign(static_cast<std::size_t>(2 * grid.rows + 1), std::string(wide, ' '));
    for (int row = 0; row <= grid.rows; ++row) {
      for (int column = 0; column <= grid.columns; ++column) {
        // Two "o" far apart could be two balls of EyeSim's.
        at(2 * row, 4 * column) = grid.columns == 1 ? '+' : 'o';
        if (column < grid.columns && wall(column, row, Side::South)) {
          for (int i = 1; i < 4; ++i) at(2 * row, 4 * column + i) = '-';
        }
        if (row < grid.rows && wall(column, row, Side::West)) at(2 * row + 1, 4 * column) = '|';
      }
    }
  }

  /// False: there is no room left in that cell.
  bool put(MazeCell cell, char mark) {
    for (const int i : {2, 1, 3}) {
      char& c = at(2 * cell.row + 1, 4 * cell.column + i);
      if (c != ' ') continue;
      c = mark;
      return true;
    }
    return false;
  }

  [[nodiscard]] std::string text() const {
    std::string out;
    for (const std::string& line : lines_) out += line + '\n';
    return out;
  }

 private:
  /// Counted from the lowest line.
  char& at(int line, int column) {
    return lines_[lines_.size() - 1 - static_cast<std::size_t>(line)]
                 [static_cast<std::size_t>(column)];
  }
  /// Of a cell that may be one beyond the last.
  [[nodiscard]] bool wall(int column, int row, Side side) const {
    if (side == Side::South && row == grid_.rows) {
      return has_wall(grid_, {column, row - 1}, Side::North);
    }
    if (side == Side::West && column == grid_.columns) {
      return has_wall(grid_, {column - 1, row}, Side::East);
    }
    return has_wall(grid_, {column, row}, side);
  }

  const world::MazeGrid& grid_;
  std::vector<std::string> lines_;
};

WrittenWorld posts_of(const world::WorldModel& model) {
  const world::MazeGrid& grid = *model.maze;
  WrittenWorld out;
  lose_what_no_maze_has(model, out.losses);
  lose_objects(model, out.losses);
  PostsDrawing drawing(grid);
  for (const world::StartPose& start : model.starts) {
    const auto cell = cell_of(grid, start.pose);
    const auto facing = letter_facing(start.pose.theta);
    if (!cell || !facing) {
      out.losses.push_back("the start at " + place_text(start.pose));
      continue;
    }
    const bool by_walls =
        capital(start.letter) == 'S' &&
        std::fabs(wrap_angle(start_in(grid, *cell).theta - start.pose.theta)) < kSame;
    const char letter = by_walls || *facing == capital(start.letter) ? start.letter : *facing;
    if (!drawing.put(*cell, letter)) {
      out.losses.push_back("one of several starts in cell " + in_words(*cell));
    } else if (letter != start.letter) {
      out.losses.push_back("the start " +
                           (start.letter == 0 ? "at " + place_text(start.pose)
                                              : "'" + std::string(1, start.letter) + "'") +
                           ", which is '" + std::string(1, letter) + "' now");
    }
  }
  if (model.starts.empty())
    out.losses.push_back("that there is no start: it is the lower left cell");
  for (const MazeCell goal : grid.goals) {
    if (!drawing.put(goal, 'G')) out.losses.push_back("the goal in cell " + in_words(goal));
  }
  if (grid.goals.empty()) out.losses.push_back("that there is no goal: it is the middle");
  out.text = drawing.text();
  if (grid.cell != kContestCell) out.text += write_millimetres(grid.cell) + '\n';
  return out;
}

WrittenWorld list_of(const world::WorldModel& model) {
  const world::MazeGrid& grid = *model.maze;
  WrittenWorld out;
  lose_what_no_maze_has(model, out.losses);
  lose_objects(model, out.losses);
  const world::WorldModel plain = contest_maze(
      [&] {
        world::MazeGrid walls = grid;
        walls.goals.clear();
        return walls;
      }(),
      {});
  if (model.starts != plain.starts) {
    out.losses.push_back("where its starts are: it is the lower left cell");
  }
  if (grid.goals != plain.maze->goals) {
    out.losses.push_back("where its goals are: they are in the middle");
  }
  if (grid.cell != kContestCell) {
    out.losses.push_back("the size of its cells: --cell " + write_millimetres(grid.cell) + "mm");
  }
  for (int column = 0; column < grid.columns; ++column) {
    for (int row = 0; row < grid.rows; ++row) {
      out.text += std::to_string(column) + " " + std::to_string(row);
      for (const Side side : kSides) out.text += has_wall(grid, {column, row}, side) ? " 1" : " 0";
      out.text += '\n';
    }
  }
  return out;
}

}  // namespace

WrittenWorld write_maze_as(MazeFormat format, const world::WorldModel& model) {
  if (!model.maze) {
    throw ConfigError({kWritten, 0, 0},
                      "it is no maze: expected a world whose walls lie on a grid");
  }
  switch (format) {
    case MazeFormat::Posts:
      return posts_of(model);
    case MazeFormat::List:
      return list_of(model);
    case MazeFormat::Drawing:
      return drawing_of(model);
    case MazeFormat::Binary:
      break;
  }
  throw ConfigError({kWritten, 0, 0}, "a format of bytes: expected one of text");
}

}  // namespace eyebridge::files
