#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "entry.hpp"
#include "eyebridge/files/foreign_worlds.hpp"

namespace eyebridge::fuzz {

/// A world that is accepted has a floor, and all of it is finite.
inline void check_world(const world::WorldModel& model) {
  if (!(model.width > 0) || !(model.height > 0) || !(model.width < 1e6)) found();
  for (const world::Wall& wall : model.walls) {
    if (wall.a == wall.b || !(wall.thickness >= 0)) found();
    for (const double v : {wall.a.x, wall.a.y, wall.b.x, wall.b.y, wall.height}) {
      if (!std::isfinite(v)) found();
    }
  }
}

/// Includes find `included`, and every picture is a small one.
inline files::NamedFiles few_files(std::string included) {
  return {[text = std::move(included)](const std::string&, const SourceLocation&) { return text; },
          [](const std::string&, const SourceLocation&) {
            return files::GreyPicture{3, 2, {0, 255, 0, 255, 127, 255}};
          }};
}

template <class Read>
void foreign(Read read) {
  std::vector<Warning> warnings;
  try {
    check_world(read(warnings));
  } catch (const ConfigError&) {  // the input is no such world
  }
}

inline void svg(std::string_view text) {
  foreign(
      [&](std::vector<Warning>& warnings) { return files::read_svg(text, "fuzz.svg", warnings); });
}

inline void stage(std::string_view text) {
  const files::NamedFiles named = few_files("define floorplan model ( size [2 1 1] )\n");
  foreign([&](std::vector<Warning>& warnings) {
    return files::read_stage(text, "fuzz.world", named, warnings);
  });
}

inline void irsim(std::string_view text) {
  const files::NamedFiles named = few_files("");
  foreign([&](std::vector<Warning>& warnings) {
    return files::read_irsim(text, "fuzz.yaml", named, warnings);
  });
}

}  // namespace eyebridge::fuzz
