#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::robios {

class Screen;

/// The LCD's text in the terminal (`--mirror`): rows that changed, five times a second at most.
class LcdMirror {
 public:
  explicit LcdMirror(const Screen& screen) : screen_(screen) {}

  /// Prints what changed to standard output. `now` on the robot's clock; `force` at the end of a
  /// run.
  void update(Time now, bool force);

 private:
  const Screen& screen_;
  Time next_{0};
  std::uint64_t revision_ = 0;
  std::vector<std::string> shown_;
};

}  // namespace eyebridge::robios
