#include <algorithm>

#include "eyebridge/files/readers.hpp"
#include "maze_formats.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

/// Bytes that no text has.
bool is_binary(std::string_view bytes) {
  return std::ranges::any_of(bytes, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f' && byte != 0x1A;
  });
}

/// Whether a line has nothing but what EyeSim's drawing of a maze has, and a wall.
bool is_drawing(std::string_view text) {
  text = without_bom(text);
  return text.find_first_not_of("|_ \t\r\n.\x1ASsUuDdLlRrOoXxGg0123456789") ==
             std::string_view::npos &&
         text.find('_') != std::string_view::npos && text.find('|') != std::string_view::npos;
}

}  // namespace

std::optional<MazeFormat> maze_format(std::string_view bytes) {
  if (is_binary(bytes)) {
    if (bytes.size() == 256 || bytes.size() == 1024) return MazeFormat::Binary;
    return std::nullopt;
  }
  if (starts_with_posts(bytes)) return MazeFormat::Posts;
  if (starts_as_list(bytes)) return MazeFormat::List;
  if (is_drawing(bytes)) return MazeFormat::Drawing;
  return std::nullopt;
}

world::WorldModel read_maze(std::string_view bytes, const std::string& file,
                            std::vector<Warning>& warnings,
                            std::vector<SourceLocation>* start_places, std::optional<double> cell) {
  const MazeSource source{bytes, file, warnings, start_places, cell};
  switch (maze_format(bytes).value_or(MazeFormat::Drawing)) {
    case MazeFormat::Posts:
      return read_posts_maze(source);
    case MazeFormat::List:
      return read_listed_maze(source);
    case MazeFormat::Binary:
      return read_binary_maze(source);
    case MazeFormat::Drawing:
      break;
  }
  return read_drawn_maze(source);
}

}  // namespace eyebridge::files
