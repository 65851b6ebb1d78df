#include <cmath>
#include <string>

#include "eyebridge/files/map_files.hpp"
#include "eyebridge/mapping/picture.hpp"
#include "file_bytes.hpp"
#include "map_limits.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

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

}  // namespace

void need_readable(const mapping::GridGeometry& geometry) {
  const auto need = [](bool holds, const std::string& text) {
    if (!holds) throw ConfigError({}, text);
  };
  need(geometry.resolution >= kLeastResolution && geometry.resolution <= kMostResolution,
       "map with cells of " + decimal(geometry.resolution) + " m: expected " +
           decimal(kLeastResolution) + " to " + decimal(kMostResolution));
  need(std::abs(geometry.origin.x) <= kMostOrigin && std::abs(geometry.origin.y) <= kMostOrigin,
       "map whose origin is at " + decimal(geometry.origin.x) + ", " + decimal(geometry.origin.y) +
           " m: expected at most " + decimal(kMostOrigin));
  need(geometry.size() <= mapping::kMostMapCells, "map of " + std::to_string(geometry.size()) +
                                                      " cells: expected at most " +
                                                      std::to_string(mapping::kMostMapCells));
}

MapTexts write_map(const mapping::OccupancyGrid& grid, const std::string& image, MapMode mode) {
  const std::string word = write_word(image);
  if (image.empty() || word.empty()) {
    throw ConfigError({image, 0, 0}, "name of a picture that no line can say");
  }
  const mapping::GridGeometry& g = grid.geometry();
  need_readable(g);
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
  write_bytes(picture, texts.pgm);
  write_bytes(path, texts.yaml);
}

}  // namespace eyebridge::files
