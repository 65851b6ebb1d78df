#pragma once

#include <string>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/robot/simulation.hpp"
#include "output_file.hpp"

namespace eyebridge::apps {

/// Where `--path` goes, if it was given: where the robots really are, as a table
/// "t,robot,x,y,theta" in s, m and radians, a row for each robot 100 times a second.
class PathFile {
 public:
  /// "" for none. Throws ConfigError when `path` cannot be written.
  explicit PathFile(const std::string& path);

  /// Adds rows for the time `now`, if the last ones are 10 ms old.
  void note(Time now, const robot::Simulation& simulation, std::size_t robots);

 private:
  OutputFile file_;
  Time due_{0};
};

}  // namespace eyebridge::apps
