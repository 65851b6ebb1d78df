#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
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
  std::optional<mapping::OccupancyGrid> turned;
  try {
    turned = files::map_of(*map, {4, 2, {0, 254, 205, 100, 89, 90, 50, 204}});
  } catch (const ConfigError&) {
    return;  // turned, it lies too far away
  }
  const mapping::OccupancyGrid& grid = *turned;
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

/// Whether a PNG or BMP says that it is so large that decoding it would take the fuzzer's time.
inline bool is_large(std::string_view bytes) {
  const auto number = [&](std::size_t at, std::size_t step) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i) {
      const auto byte = static_cast<unsigned char>(bytes[at + (step == 1 ? i : 3 - i)]);
      value = value << 8U | byte;
    }
    return std::min<std::uint64_t>(value, 1U << 20U);
  };
  if (bytes.size() < 30) return false;
  if (bytes.starts_with("BM")) return number(18, 2) * number(22, 2) > 1'000'000;
  return bytes.starts_with("\x89PNG") && number(16, 1) * number(20, 1) > 1'000'000;
}

/// A picture is as large as it says, and a PNM takes no more memory than its file.
inline void map_pgm(std::string_view bytes) {
  if (is_large(bytes)) return;
  try {
    const files::GreyPicture picture = files::read_map_picture(bytes, "fuzz.pgm");
    const std::size_t count =
        static_cast<std::size_t>(picture.columns) * static_cast<std::size_t>(picture.rows);
    if (count < 1 || count != picture.greys.size()) found();
    if (bytes[0] == 'P' && count > 8 * bytes.size()) found();
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
