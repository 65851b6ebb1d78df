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

/// A key press, a touch, or a key of the infrared remote control, that a script foresees.
struct ScriptedKey {
  Time at{0};        ///< On the robot's clock.
  int key = 0;       ///< Mask of one key, 1, 2, 4 or 8; else 0.
  TouchPoint touch;  ///< Where, when key and remote are 0.
  int remote = 0;    ///< Code of a key of the remote control (IRTV_5), else 0.
  int robot = 0;     ///< Whose alone it is, as OSMachineID() counts, from 1; 0: everybody's.

  friend bool operator==(const ScriptedKey&, const ScriptedKey&) = default;
};

/// Reads "KEY1@2s,KEY4@10s": keys KEY1..KEY4, touches as "120:80", or keys of the remote control by
/// the names of eyebot.h (IRTV_0..IRTV_9, IRTV_RED, IRTV_OK …), each with a time on the
/// robot's clock in s, ms or min (s when nothing is said), in any order; sorted by time. Before
/// each of them may stand a robot's number: "2:KEY1@2s", "2:120:80@3s". "" is an empty script.
/// Throws ConfigError{"--keys", 1, column}.
std::vector<ScriptedKey> parse_key_script(std::string_view text);

}  // namespace eyebridge::robios
