#pragma once

#include <string_view>
#include <vector>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::robios {

/// A place on the screen, LCD pixels.
struct TouchPoint {
  int x = 0;
  int y = 0;

  friend bool operator==(const TouchPoint&, const TouchPoint&) = default;
};

/// A key press, or a touch, that a script foresees.
struct ScriptedKey {
  Time at{0};        ///< On the robot's clock.
  int key = 0;       ///< Mask of one key, 1, 2, 4 or 8; 0 for a touch.
  TouchPoint touch;  ///< Where, when key is 0.

  friend bool operator==(const ScriptedKey&, const ScriptedKey&) = default;
};

/// Reads "KEY1@2s,KEY4@10s": keys KEY1..KEY4, or touches as "120:80", each with a time on the
/// robot's clock in s, ms or min (s when nothing is said), in any order; sorted by time. "" is an
/// empty script. Throws ConfigError{"--keys", 1, column}.
std::vector<ScriptedKey> parse_key_script(std::string_view text);

}  // namespace eyebridge::robios
