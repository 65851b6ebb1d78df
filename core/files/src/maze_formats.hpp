#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/files/readers.hpp"

namespace eyebridge::files {

// One reader for each format that mazes are kept in; read_maze() asks maze_format() which.

/// What readers of mazes are given.
struct MazeSource {
  std::string_view bytes;
  const std::string& file;
  std::vector<Warning>& warnings;
  std::vector<SourceLocation>* start_places = nullptr;
  std::optional<double> cell = {};  ///< Edge length of a cell that counts whatever the file says.
};

/// EyeSim's drawing, with `|` and `_`.
world::WorldModel read_drawn_maze(const MazeSource& source);
/// A drawing with posts, `o` or `+`, and walls between them, `---` and `|`.
world::WorldModel read_posts_maze(const MazeSource& source);
/// A list of cells: `x y north east south west`.
world::WorldModel read_listed_maze(const MazeSource& source);
/// A byte for each cell of 16 x 16, or of 32 x 32.
world::WorldModel read_binary_maze(const MazeSource& source);

/// Whether the first line that has a character is one of posts.
bool starts_with_posts(std::string_view text);
/// Whether the first line that has a word is six whole numbers.
bool starts_as_list(std::string_view text);

}  // namespace eyebridge::files
