#include "maze_layout.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "eyebridge/base/units.hpp"

namespace eyebridge::files {
namespace {

using world::MazeCell;
using world::MazeGrid;

constexpr std::size_t kMostInARow = 32768;
constexpr std::size_t kMostLines = 100000;

std::string_view without_end(std::string_view line) {
  while (!line.empty() && (line.back() == ' ' || line.back() == '\r' || line.back() == 0x1A)) {
    line.remove_suffix(1);
  }
  return line;
}

std::vector<char> MazeGrid::*flags_of(Side side) {
  return side == Side::North || side == Side::South ? &MazeGrid::south : &MazeGrid::west;
}

std::size_t index_of(const MazeGrid& grid, MazeCell cell, Side side) {
  const int column = cell.column + (side == Side::East ? 1 : 0);
  const int row = cell.row + (side == Side::North ? 1 : 0);
  const int width = flags_of(side) == &MazeGrid::south ? grid.columns : grid.columns + 1;
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(column);
}

double heading_to(Side side) {
  switch (side) {
    case Side::North:
      return kPi / 2;
    case Side::East:
      return 0.0;
    case Side::South:
      return -kPi / 2;
    case Side::West:
      return kPi;
  }
  return 0.0;
}

}  // namespace

std::vector<MazeLine> maze_lines(std::string_view text, const std::string& file) {
  text = without_bom(text);
  check_text(text, file);
  std::vector<MazeLine> lines;
  int line = 0;
  while (!text.empty()) {
    if (lines.size() == kMostLines) {
      throw ConfigError({file, line, 1}, "maze of more than " + std::to_string(kMostLines) +
                                             " lines: expected fewer");
    }
    const std::size_t end = text.find('\n');
    lines.push_back({without_end(text.substr(0, end)), ++line});
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  const auto is_drawn = [](const MazeLine& drawn) { return !drawn.text.empty(); };
  while (!lines.empty() && !is_drawn(lines.back())) lines.pop_back();
  lines.erase(lines.begin(), std::find_if(lines.begin(), lines.end(), is_drawn));
  return lines;
}

std::optional<double> cell_size_in(const MazeLine& line, const std::string& file) {
  StatementReader statements(line.text, file);
  Statement s;
  if (line.text.find_first_of("\"'") != std::string_view::npos || !statements.next(s) ||
      s.size() != 1 || !s.is_number(0)) {
    return std::nullopt;
  }
  try {
    return s.millimetres(0, "the size of a cell", kLeastCell, kMostCell);
  } catch (const ConfigError& error) {  // the statement counts its lines from this one
    throw ConfigError({file, line.line, error.where().column}, error.text());
  }
}

std::optional<double> facing_of(char letter) {
  switch (letter) {
    case 'U':
    case 'u':
      return kPi / 2;
    case 'D':
    case 'd':
      return -kPi / 2;
    case 'L':
    case 'l':
      return kPi;
    case 'R':
    case 'r':
      return 0.0;
    default:
      return std::nullopt;
  }
}

std::string in_words(MazeCell cell) {
  return std::to_string(cell.column) + " " + std::to_string(cell.row);
}

MazeGrid empty_maze(std::size_t columns, std::size_t rows, const SourceLocation& where) {
  if (columns == 0 || rows == 0) throw ConfigError(where, "no cell in the maze: expected one");
  if (columns > kMostInARow || rows > kMostInARow || columns * rows > kMostMazeCells) {
    throw ConfigError(where, "maze of " + std::to_string(columns) + " x " + std::to_string(rows) +
                                 " cells: expected at most " + std::to_string(kMostMazeCells) +
                                 " cells");
  }
  MazeGrid grid;
  grid.columns = static_cast<int>(columns);
  grid.rows = static_cast<int>(rows);
  grid.south.assign(columns * (rows + 1), 0);
  grid.west.assign((columns + 1) * rows, 0);
  return grid;
}

char& edge(MazeGrid& grid, MazeCell cell, Side side) {
  return (grid.*flags_of(side))[index_of(grid, cell, side)];
}

bool has_wall(const MazeGrid& grid, MazeCell cell, Side side) {
  return (grid.*flags_of(side))[index_of(grid, cell, side)] != 0;
}

Pose start_in(const MazeGrid& grid, MazeCell cell) {
  Pose pose{(cell.column + 0.5) * grid.cell, (cell.row + 0.5) * grid.cell, kPi / 2};
  for (const Side side : {Side::North, Side::East, Side::West, Side::South}) {
    if (has_wall(grid, cell, side)) continue;
    pose.theta = heading_to(side);
    break;
  }
  return pose;
}

std::vector<MazeCell> centre_of(const MazeGrid& grid) {
  std::vector<MazeCell> cells;
  for (int row = (grid.rows - 1) / 2; row <= grid.rows / 2; ++row) {
    for (int column = (grid.columns - 1) / 2; column <= grid.columns / 2; ++column) {
      cells.push_back({column, row});
    }
  }
  return cells;
}

void sort_goals(MazeGrid& grid) {
  std::ranges::sort(grid.goals, {}, [](MazeCell cell) { return std::pair(cell.row, cell.column); });
  grid.goals.erase(std::unique(grid.goals.begin(), grid.goals.end()), grid.goals.end());
}

world::WorldModel contest_maze(MazeGrid grid, std::vector<world::StartPose> starts) {
  if (starts.empty()) starts.push_back({'S', start_in(grid, {})});
  if (grid.goals.empty()) grid.goals = centre_of(grid);
  sort_goals(grid);
  world::WorldModel model;
  model.width = grid.columns * grid.cell;
  model.height = grid.rows * grid.cell;
  model.walls = world::walls_of(grid);
  model.starts = std::move(starts);
  model.maze = std::move(grid);
  return model;
}

void warn_of_gaps(const MazeGrid& grid, Warnings& warnings,
                  const std::function<SourceLocation(MazeCell, Side)>& place) {
  const auto is_wall = [](char flag) { return flag != 0; };
  const auto add = [&](const SourceLocation& where, std::string text) {
    warnings.add(where.line, where.column, std::move(text));
  };
  if (std::ranges::none_of(grid.south, is_wall) && std::ranges::none_of(grid.west, is_wall)) {
    return add(place({0, grid.rows - 1}, Side::North), "a maze without walls");
  }
  int gaps = 0;
  std::optional<std::pair<MazeCell, Side>> first;
  const auto look = [&](MazeCell cell, Side side) {
    if (has_wall(grid, cell, side)) return;
    if (gaps++ == 0) first = {cell, side};
  };
  for (int column = 0; column < grid.columns; ++column) look({column, grid.rows - 1}, Side::North);
  for (int row = grid.rows - 1; row >= 0; --row) {
    look({0, row}, Side::West);
    look({grid.columns - 1, row}, Side::East);
  }
  for (int column = 0; column < grid.columns; ++column) look({column, 0}, Side::South);
  if (!first) return;
  add(place(first->first, first->second),
      "the outer boundary is open here" +
          (gaps == 1 ? std::string() : " and at " + std::to_string(gaps - 1) + " more places") +
          ": a robot can leave the maze");
}

}  // namespace eyebridge::files
