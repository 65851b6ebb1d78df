#pragma once

#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/files/readers.hpp"

// What the fuzz targets and the test over their corpus do with one input. Anything but a model or
// a ConfigError ends the process: that is a finding.
namespace eyebridge::fuzz {

/// Ends the process: what was read did not survive being written.
[[noreturn]] inline void found() { std::abort(); }

inline void world(std::string_view text) {
  std::vector<Warning> warnings;
  try {
    const auto model = files::read_world(text, "fuzz.wld", warnings);
    std::string written;
    try {
      written = files::write_world(model);
    } catch (const ConfigError&) {
      found();
    }
    if (files::read_world(written, "again.wld", warnings) != model) found();
  } catch (const ConfigError&) {  // the input is no world
  }
}

inline void maze(std::string_view text) {
  std::vector<Warning> warnings;
  try {
    const auto model = files::read_maze(text, "fuzz.maz", warnings);
    std::string written;
    try {
      written = files::write_maze(model);
    } catch (const ConfigError&) {
      found();
    }
    if (files::read_maze(written, "again.maz", warnings) != model) found();
  } catch (const ConfigError&) {  // the input is no maze
  }
}

inline void robi(std::string_view text) {
  std::vector<Warning> warnings;
  try {
    static_cast<void>(files::read_robi(text, "fuzz.robi", warnings));
  } catch (const ConfigError&) {  // the input is no robot
  }
}

inline void sim(std::string_view text) {
  std::vector<Warning> warnings;
  try {
    static_cast<void>(files::read_sim(text, "fuzz.sim", warnings));
  } catch (const ConfigError&) {  // the input is no simulation
  }
}

inline void parameter(std::string_view text) {
  std::vector<Warning> warnings;
  try {
    static_cast<void>(files::read_parameter_file(text, "fuzz.p", warnings));
  } catch (const ConfigError&) {  // the input is no parameter file
  }
}

}  // namespace eyebridge::fuzz
