#include <charconv>
#include <cmath>
#include <fstream>
#include <string>

#include "eyebridge/files/map_files.hpp"
#include "eyebridge/mapping/picture.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

/// The shortest decimal number that is read back as `value`.
std::string decimal(double value) {
  char buffer[64];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, result.ptr};
}

std::uint8_t rounded(double value) { return static_cast<std::uint8_t>(std::nearbyint(value)); }

std::uint8_t grey_in(const mapping::OccupancyGrid& grid, mapping::Cell cell, MapMode mode) {
  const double p = grid.probability(cell);
  if (mode == MapMode::Raw) {
    return grid.log_odds(cell) == grid.prior() ? 255 : rounded(100.0 * p);
  }
  // Scaled back when it is read.
  const mapping::OccupancySettings& s = grid.settings();
  const double scaled = s.free_below + p * (s.occupied_above - s.free_below);
  return rounded(255.0 * (1.0 - scaled));
}

std::string pgm_of(const mapping::OccupancyGrid& grid, MapMode mode) {
  const mapping::GridGeometry& g = grid.geometry();
  std::string pgm = "P5\n" + std::to_string(g.columns) + " " + std::to_string(g.rows) + "\n255\n";
  const auto states = mapping::picture_of(grid);
  for (int row = g.rows - 1; row >= 0; --row) {
    for (int column = 0; column < g.columns; ++column) {
      const mapping::Cell cell{column, row};
      const std::uint8_t grey = mode == MapMode::Trinary ? states[cell] : grey_in(grid, cell, mode);
      pgm += static_cast<char>(grey);
    }
  }
  return pgm;
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary);
  out << bytes;
  out.flush();
  if (!out) throw ConfigError({path.string(), 0, 0}, "cannot be written");
}

}  // namespace

MapTexts write_map(const mapping::OccupancyGrid& grid, const std::string& image, MapMode mode) {
  const std::string word = write_word(image);
  if (image.empty() || word.empty()) {
    throw ConfigError({image, 0, 0}, "name of a picture that no line can say");
  }
  const mapping::GridGeometry& g = grid.geometry();
  // Of the greys of a trinary map, ROS's thresholds part the three; other thresholds may not.
  const bool scaled = mode == MapMode::Scale;
  const double occupied = scaled ? grid.settings().occupied_above : 0.65;
  const double free = scaled ? grid.settings().free_below : 0.196;
  constexpr const char* kModes[] = {"trinary", "scale", "raw"};
  MapTexts texts;
  texts.yaml = "image: " + word + "\nmode: " + kModes[static_cast<int>(mode)] +
               "\nresolution: " + decimal(g.resolution) + "\norigin: [" + decimal(g.origin.x) +
               ", " + decimal(g.origin.y) +
               ", 0]\nnegate: 0\noccupied_thresh: " + decimal(occupied) +
               "\nfree_thresh: " + decimal(free) + "\n";
  texts.pgm = pgm_of(grid, mode);
  return texts;
}

void save_map(const mapping::OccupancyGrid& grid, const std::filesystem::path& path, MapMode mode) {
  std::filesystem::path picture = path;
  picture.replace_extension(".pgm");
  if (picture == path) {
    throw ConfigError({path.string()}, "found a picture's name for a map, expected .yaml");
  }
  const MapTexts texts = write_map(grid, picture.filename().string(), mode);
  write_file(picture, texts.pgm);
  write_file(path, texts.yaml);
}

}  // namespace eyebridge::files
