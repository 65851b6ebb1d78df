#include "fault/fault_backend.hpp"

#include <algorithm>
#include <utility>

namespace eyebridge::hal {

Result<void> FaultyLidar::read(std::span<double> ranges) {
  auto scan = gate_.reading(scan_, [&]() -> Result<std::vector<double>> {
    return inner_.read(ranges).map([&] { return std::vector(ranges.begin(), ranges.end()); });
  });
  if (!scan) return tl::unexpected(scan.error());
  if (scan->size() != ranges.size()) {
    return fail(Errc::Corrupt, "lidar: the scan that it froze with has another number of points");
  }
  std::copy(scan->begin(), scan->end(), ranges.begin());
  return {};
}

FaultBackend::FaultBackend(std::unique_ptr<Backend> inner, FaultScript script, std::uint64_t seed)
    : inner_(std::move(inner)), script_(std::move(script)), seed_(seed) {}

template <class Faulty, class Device>
Faulty* FaultBackend::wrap(Slots<Faulty>& slots, const char* kind, int id, Device* device) {
  if (device == nullptr) return nullptr;
  const std::lock_guard lock(mutex_);
  return &slots.try_emplace(id, *this, kind, id, *device).first->second.faulty;
}

Drive* FaultBackend::drive() { return wrap(drives_, "drive", 1, inner_->drive()); }
RangeSensor* FaultBackend::range_sensor(int id) {
  return wrap(range_sensors_, "psd", id, inner_->range_sensor(id));
}
SwitchSensor* FaultBackend::proximity(int id) {
  return wrap(proximity_sensors_, "proximity", id, inner_->proximity(id));
}
SwitchSensor* FaultBackend::bumper(int id) {
  return wrap(bumpers_, "bumper", id, inner_->bumper(id));
}
Lidar* FaultBackend::lidar() { return wrap(lidars_, "lidar", 1, inner_->lidar()); }
Compass* FaultBackend::compass() { return wrap(compasses_, "compass", 1, inner_->compass()); }
Motor* FaultBackend::motor(int id) { return wrap(motors_, "motor", id, inner_->motor(id)); }
Encoder* FaultBackend::encoder(int id) {
  return wrap(encoders_, "encoder", id, inner_->encoder(id));
}
Servo* FaultBackend::servo(int id) { return wrap(servos_, "servo", id, inner_->servo(id)); }

}  // namespace eyebridge::hal
