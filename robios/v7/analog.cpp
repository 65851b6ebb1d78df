#include <algorithm>
#include <cstdint>
#include <vector>

#include "analog_recorder.hpp"
#include "convert.hpp"
#include "eyebot.h"
#include "guarded.hpp"

namespace {

using namespace eyebridge;
using robios::Session;

constexpr double kCentivolts = 100;

/// Runs `body` on the robot's inputs.
template <class Body>
int with_inputs(const robios::Call& call, int failure, Body&& body) {
  return robios::guarded(call, failure, [&](Session& session) -> Result<int> {
    hal::AnalogInputs* inputs = session.backend().analog();
    if (inputs == nullptr) return fail(Errc::NoDevice, "this robot has no analog inputs");
    return body(*inputs, session);
  });
}

}  // namespace

int ANALOGRead(int channel) {
  return with_inputs("ANALOGRead", -1,
                     [&](hal::AnalogInputs& inputs, Session&) { return inputs.read(channel); });
}

int ANALOGVoltage(void) {
  return with_inputs("ANALOGVoltage", -1, [](hal::AnalogInputs& inputs, Session&) {
    return inputs.supply_voltage().map(
        [](double volts) { return robios::to_whole(volts * kCentivolts); });
  });
}

int ANALOGRecord(int channel, int iterations) {
  return with_inputs("ANALOGRecord", 1, [&](hal::AnalogInputs& inputs, Session& session) {
    return session.recorder().start(inputs, channel, iterations).map([] { return 0; });
  });
}

int ANALOGTransfer(BYTE* buffer) {
  return robios::guarded("ANALOGTransfer", 0, [&](Session& session) -> Result<int> {
    if (buffer == nullptr) return robios::null_pointer();
    return session.recorder()
        .take([&](Time until) { session.wait_until(until); })
        .map([&](const std::vector<std::uint8_t>& samples) {
          std::copy(samples.begin(), samples.end(), buffer);
          return static_cast<int>(samples.size());
        });
  });
}

int AUMicrophone(void) {
  return with_inputs("AUMicrophone", -1, [](hal::AnalogInputs& inputs, Session&) {
    return inputs.read(hal::AnalogInputs::kMicrophone);
  });
}
