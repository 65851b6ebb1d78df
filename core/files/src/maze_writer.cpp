#include <cmath>

#include "eyebridge/files/readers.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

const std::string kName = "maze to write";

[[noreturn]] void refuse(const std::string& why) { throw ConfigError({kName, 0, 0}, why); }

/// The drawing, one string a line; what stands in the cells replaces their `_`.
class Drawing {
 public:
  explicit Drawing(const world::MazeGrid& grid)
      : grid_(grid),
        columns_(static_cast<std::size_t>(grid.columns)),
        rows_(static_cast<std::size_t>(grid.rows)),
        lines_(rows_ + 1, std::string(2 * columns_ + 1, ' ')) {
    for (std::size_t r = 0; r <= rows_; ++r) {
      const std::size_t boundary = rows_ - r;
      for (std::size_t c = 0; c < columns_; ++c) {
        if (grid.south[boundary * columns_ + c] != 0) lines_[r][2 * c + 1] = '_';
      }
      for (std::size_t c = 0; r > 0 && c <= columns_; ++c) {
        if (grid.west[boundary * (columns_ + 1) + c] != 0) lines_[r][2 * c] = '|';
      }
      // A dot means nothing to the reader, but keeps the outermost column and empty lines.
      if (lines_[r].back() == ' ') lines_[r].back() = '.';
    }
  }

  /// `letter` at `pose`; an upper-case `with_wall` stands in for it where a wall lies below.
  void put(const Pose& pose, char letter, char with_wall) {
    const double half = grid_.cell / 2;
    const double x = std::nearbyint(pose.x / half);
    const double y = std::floor(pose.y / grid_.cell);
    if (!(x >= 0 && x <= 2.0 * grid_.columns && y >= 0 && y < grid_.rows)) {
      refuse("something stands outside the maze");
    }
    char& c = lines_[rows_ - static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
    if (c == '_') {
      c = with_wall;
    } else if (c == ' ' || c == '.') {
      c = letter;
    } else {
      refuse("two things stand in one place");
    }
  }

  std::string text() const {
    std::string out;
    for (const std::string& line : lines_) out += line + '\n';
    return out + write_millimetres(grid_.cell) + '\n';
  }

 private:
  const world::MazeGrid& grid_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<std::string> lines_;
};

}  // namespace

std::string write_maze(const world::WorldModel& model) {
  if (!model.maze) refuse("it is no maze: expected a world drawn on a grid (write_world)");
  const world::MazeGrid& grid = *model.maze;
  const auto columns = static_cast<std::size_t>(grid.columns);
  const auto rows = static_cast<std::size_t>(grid.rows);
  if (grid.columns < 1 || grid.rows < 1 || grid.south.size() != columns * (rows + 1) ||
      grid.west.size() != (columns + 1) * rows) {
    refuse("its grid is incomplete");
  }
  Drawing drawing(grid);
  for (const world::StartPose& start : model.starts) {
    drawing.put(start.pose, start.letter, start.letter);
  }
  for (const world::MazeCell goal : grid.goals) {
    drawing.put({(goal.column + 0.5) * grid.cell, (goal.row + 0.5) * grid.cell, 0}, 'g', 'G');
  }
  for (const world::ObjectSpec& object : model.objects) {
    if (object.name == "golf") {
      drawing.put(object.pose, 'o', 'O');
    } else if (object.name == "crate") {
      drawing.put(object.pose, 'x', 'X');
    } else {
      refuse("it has a '" + object.name + "': a maze can draw golf balls and crates only");
    }
  }
  std::string text = drawing.text();
  std::vector<Warning> warnings;
  if (read_maze(text, kName, warnings) != model) {
    refuse("a maze cannot draw all of it (poses off the grid, other walls, markers or a texture)");
  }
  return text;
}

}  // namespace eyebridge::files
