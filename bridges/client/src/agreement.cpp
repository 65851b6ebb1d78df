#include "agreement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "opcodes.h"

namespace eyebridge::bridges {
namespace {

constexpr Time kLongest = std::chrono::milliseconds(20);  // beyond, another reading tells more
constexpr Time kPeriod = std::chrono::milliseconds(10);
constexpr int kTurn = 360;
constexpr std::size_t kHeading = 2;  // of a pose

/// How far apart value `index` of two replies may be. Ranges and voltages differ by their noise,
/// ranges from near also by some millimetres of the robot's way.
int tolerance(char letter, int larger, Time apart) {
  switch (letter) {
    case IO7_PSD:
    case IO7_ANALOG:
      return 16 + larger / 16;
    case IO7_ENCODER:
      return 8 + static_cast<int>(IO7_TICKS_LAST * std::min(apart, kLongest) / kPeriod);
    case IO7_VOLTAGE:
    case IO7_VW_GET_SPEED:
      return 30;
    case IO7_VW_GET_POSE:
    case IO7_VW_REMAINING:
      return 10;
    default:
      return 0;
  }
}

/// Values that begin anew behind their last one; 0 for those that do not.
int wraps_after(char letter, std::size_t index) {
  if (letter == IO7_ENCODER) return IO7_COUNTER_LAST + 1;
  return letter == IO7_VW_GET_POSE && index == kHeading ? kTurn : 0;
}

}  // namespace

bool agree(const io7::Reply& a, const io7::Reply& b, Time apart) {
  if (a.letter != b.letter || a.count != b.count || a.version != b.version) return false;
  for (std::size_t i = 0; i < a.count; ++i) {
    int difference = std::abs(a.values[i] - b.values[i]);
    if (const int round = wraps_after(a.letter, i); round != 0) {
      difference = std::min(difference % round, round - difference % round);
    }
    if (difference > tolerance(a.letter, std::max(a.values[i], b.values[i]), apart)) return false;
  }
  return true;
}

}  // namespace eyebridge::bridges
