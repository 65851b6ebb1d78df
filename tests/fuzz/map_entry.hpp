#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "entry.hpp"
#include "eyebridge/files/map_files.hpp"

namespace eyebridge::fuzz {

/// The grid has cells, and they lie somewhere.
inline void check_map(const mapping::OccupancyGrid& grid) {
  const mapping::GridGeometry& g = grid.geometry();
  if (g.size() < 1 || g.size() > mapping::kMostMapCells || !(g.resolution > 0.0)) found();
  if (!std::isfinite(g.origin.x) || !std::isfinite(g.origin.y)) found();
  for (const float value : grid.raster().cells) {
    if (!(value >= grid.lowest() && value <= grid.highest())) found();
  }
}

/// A map's `.yaml` that is accepted says what a grid can be, and survives being written and read.
inline void map_yaml(std::string_view text) {
  std::vector<Warning> warnings;
  std::optional<files::MapDescription> map;
  try {
    map = files::read_map_description(text, "fuzz.yaml", warnings);
  } catch (const ConfigError&) {
    return;  // the input is no description
  }
  const mapping::OccupancyGrid grid =
      files::map_of(*map, {4, 2, {0, 254, 205, 100, 89, 90, 50, 204}});
  check_map(grid);
  try {
    const files::MapTexts texts = files::write_map(grid, "fuzz.pgm");
    const mapping::OccupancyGrid again =
        files::map_of(files::read_map_description(texts.yaml, "again.yaml", warnings),
                      files::read_map_picture(texts.pgm, "again.pgm"));
    if (again.geometry() != grid.geometry()) found();
    for (std::size_t i = 0; i < grid.raster().cells.size(); ++i) {
      if (again.state_of(again.raster().cells[i]) != grid.state_of(grid.raster().cells[i])) found();
    }
  } catch (const ConfigError&) {  // we wrote it
    found();
  }
}

/// A picture is as large as it says, and takes no more memory than its file.
inline void map_pgm(std::string_view bytes) {
  try {
    const files::GreyPicture picture = files::read_map_picture(bytes, "fuzz.pgm");
    const std::size_t count =
        static_cast<std::size_t>(picture.columns) * static_cast<std::size_t>(picture.rows);
    if (count < 1 || count != picture.greys.size() || count > 8 * bytes.size()) found();
    check_map(files::map_of({}, picture));
  } catch (const ConfigError&) {  // the input is no picture
  }
}

/// What is written is read back the same.
inline void map_csv(std::string_view text) {
  std::optional<mapping::OccupancyGrid> grid;
  try {
    grid = files::read_map_csv(text, "fuzz.csv");
  } catch (const ConfigError&) {
    return;  // the input is no grid
  }
  check_map(*grid);
  try {
    const std::string written = files::write_map_csv(*grid);
    const mapping::OccupancyGrid again = files::read_map_csv(written, "again.csv");
    if (again.geometry() != grid->geometry() || files::write_map_csv(again) != written) found();
  } catch (const ConfigError&) {  // we wrote it
    found();
  }
}

}  // namespace eyebridge::fuzz
