#include "board/board_sensors.hpp"

#include "arguments/arguments.hpp"
#include "board/board_units.hpp"

namespace eyebridge::hal {

Result<double> BoardRangeSensor::read() {
  if (table_.metres.empty()) return link_.psd_metres(id_);
  return link_.psd_raw(id_).map([this](int raw) { return to_metres(table_, raw); });
}

Result<int> BoardAnalog::read(int channel) {
  return check_channel(channel).and_then([&] { return link_.analog(channel); });
}

Result<int> BoardRemote::read() {
  const std::lock_guard lock(mutex_);
  return link_.remote_key().map([&](int held) {
    const int before = held_;
    held_ = held;
    return held == before ? 0 : held;
  });
}

}  // namespace eyebridge::hal
