#include <algorithm>
#include <cmath>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/hdt.hpp"

namespace eyebridge::files {
namespace {

constexpr int kOutOfRangeMm = 9999;
constexpr int kTopReading = 4095;  // 12 bits

/// Between the entries on both sides of `index`, which lies in the table.
double between(const std::vector<int>& values, double index) {
  const auto low = static_cast<std::size_t>(index);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  const double part = index - static_cast<double>(low);
  return values[low] + part * (values[high] - values[low]);
}

}  // namespace

double motor_duty(const HdtTable* table, double speed) {
  if (std::isnan(speed)) return 0.0;
  const double clamped = std::clamp(speed, -1.0, 1.0);
  if (table == nullptr) return clamped;
  const double percent = between(table->values, 100.0 * std::abs(clamped));
  return std::copysign(percent / 100.0, clamped);
}

int servo_position(const HdtTable* table, double position) {
  const double wanted = std::isnan(position) ? 0.5 : std::clamp(position, 0.0, 1.0);
  const long nearest = std::lround(255.0 * wanted);
  return table == nullptr ? static_cast<int>(nearest)
                          : table->values[static_cast<std::size_t>(nearest)];
}

double psd_range(const HdtTable& table, int raw) {
  const std::size_t count = table.values.size();
  const auto last = static_cast<double>(count - 1);
  const double index = count < kTopReading + 1 ? raw * last / kTopReading : raw;
  if (!(index >= 0.0) || index > last) return kHdtOutOfRange;
  const auto entry = [&](double at) { return table.values[static_cast<std::size_t>(at)]; };
  if (std::max(entry(std::floor(index)), entry(std::ceil(index))) >= kOutOfRangeMm) {
    return mm_to_m(std::min(entry(std::floor(index + 0.5)), kOutOfRangeMm));
  }
  return mm_to_m(between(table.values, index));
}

ServoLimits servo_limits(const HdtServo& servo) {
  const auto tens = [](double seconds) {
    return std::clamp(static_cast<int>(std::lround(seconds * 1e5)), 0, 255);
  };
  return {tens(servo.shortest_pulse), tens(servo.longest_pulse)};
}

}  // namespace eyebridge::files
