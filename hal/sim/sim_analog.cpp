#include "sim/sim_analog.hpp"

#include "arguments/arguments.hpp"

namespace eyebridge::hal {
namespace {

constexpr int kSilence = 2048;

}  // namespace

Result<int> SimAnalog::read(int channel) {
  return check_channel(channel).map([&] {
    if (channel == kMicrophone) return kSilence;
    return channel == kSupply ? static_cast<int>(supply_voltage_ / kVoltsAtMost * kMost) : 0;
  });
}

}  // namespace eyebridge::hal
