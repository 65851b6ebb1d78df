#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {

enum class FaultEffect {
  Lose,    ///< Calls fail with Disconnected.
  Drop,    ///< A share of the calls fails with Timeout.
  Freeze,  ///< Readings stay what they were; commands are accepted and not carried out.
  Delay,   ///< The answer takes longer, on the robot's clock.
};

/// What happens to some devices for some time.
struct FaultRule {
  std::string device;  ///< One of kDeviceKinds, or "all".
  int id = 0;          ///< Of that device; 0 is each.
  FaultEffect effect{};
  double value = 0.0;  ///< Of Drop the share, 0 … 1; of Delay seconds.
  Time from{0};
  Time to = Time::max();
  std::string text;  ///< As it was written, for messages.

  /// Whether the rule is about the device and holds at `now`.
  [[nodiscard]] bool holds(std::string_view kind, int number, Time now) const;
};

/// Rules, the first that holds and fails a call decides.
using FaultScript = std::vector<FaultRule>;

/// Reads "psd:1 lose @2s..4s; drive freeze @5s; all delay 20ms; motor:2 drop 10%".
///
/// A rule is DEVICE[:ID] EFFECT [VALUE] [@FROM[..TO]] with the effects lose, freeze, drop PERCENT%
/// and delay DURATION; rules are separated by ';'. Throws ConfigError at `where` with the column of
/// the rule.
FaultScript parse_fault_script(std::string_view text, const SourceLocation& where);

}  // namespace eyebridge::hal
