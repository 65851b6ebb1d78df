#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/files/maze_limits.hpp"
#include "eyebridge/files/scenario.hpp"
#include "text.hpp"

namespace eyebridge::files {

// What all formats of mazes have in common: a grid of cells, where a contest's robot stands in it,
// and what is odd about it.

/// Edge length of a cell where the format of a contest says nothing, metres.
inline constexpr double kContestCell = 0.18;
/// What a file may say of it, millimetres.
inline constexpr double kLeastCell = 1000 * kLeastMazeCell;
inline constexpr double kMostCell = 1000 * kMostMazeCell;

enum class Side { North, East, South, West };
inline constexpr Side kSides[] = {Side::North, Side::East, Side::South, Side::West};

/// A line of a drawing.
struct MazeLine {
  std::string_view text;  ///< Without blanks at its end.
  int line = 0;           ///< From 1.
};
/// The lines of a drawing from its first to its last that is not empty; they borrow from `text`.
/// Throws ConfigError for bytes that are no text, and for more than 100,000 lines.
std::vector<MazeLine> maze_lines(std::string_view text, const std::string& file);
/// The edge length of a cell, metres, if that is all that a line says. Throws ConfigError for one
/// that no cell has.
std::optional<double> cell_size_in(const MazeLine& line, const std::string& file);

/// Where a robot faces that starts at one of the letters U, D, L, R, in any case; radians.
std::optional<double> facing_of(char letter);

/// "3 5": column and row.
std::string in_words(world::MazeCell cell);

/// A grid without walls. Throws ConfigError at `where` when that is no cell or too many.
world::MazeGrid empty_maze(std::size_t columns, std::size_t rows, const SourceLocation& where);

/// The flag of an edge of a cell that is in the grid.
char& edge(world::MazeGrid& grid, world::MazeCell cell, Side side);
bool has_wall(const world::MazeGrid& grid, world::MazeCell cell, Side side);

/// The middle of a cell, facing the first side that is open: north, east, west, south.
Pose start_in(const world::MazeGrid& grid, world::MazeCell cell);

/// The cell, or the four, in the middle: where a contest run ends.
std::vector<world::MazeCell> centre_of(const world::MazeGrid& grid);

/// From the lowest row, each from the left; each cell once.
void sort_goals(world::MazeGrid& grid);

/// The maze of a contest: where its file names no start, that is the lower left cell, and where it
/// names no goal, those are the cells in the middle.
world::WorldModel contest_maze(world::MazeGrid grid, std::vector<world::StartPose> starts);

/// Warns of a grid without walls, and of an outer boundary that is open. `place` is where an edge
/// of a cell stands in the file.
void warn_of_gaps(const world::MazeGrid& grid, Warnings& warnings,
                  const std::function<SourceLocation(world::MazeCell, Side)>& place);

}  // namespace eyebridge::files
