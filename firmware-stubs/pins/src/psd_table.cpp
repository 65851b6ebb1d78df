#include "eyebridge/pins/psd_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge::pins {
namespace {

constexpr int kOutOfRange = 9999;
constexpr double kOffset = 500.0;  // millimetres
constexpr double kScale = 4095.0 * kOffset;
constexpr int kPsds = 6;

constexpr auto kTable = [] {
  std::array<std::uint16_t, 4096> table{};
  for (std::size_t raw = 0; raw < table.size(); ++raw) {
    const double mm = raw == 0 ? kOutOfRange : kScale / static_cast<double>(raw) - kOffset;
    table[raw] = static_cast<std::uint16_t>(mm >= kOutOfRange ? kOutOfRange : mm + 0.5);
  }
  return table;
}();

double ticks_per_metre(const robot::DriveModel& drive) {
  return drive.ticks_per_revolution / (kPi * drive.wheel_diameter);
}

}  // namespace

std::span<const std::uint16_t, 4096> psd_table() { return kTable; }

std::uint16_t psd_raw(double range) {
  const double mm = m_to_mm(range);
  if (!(mm < kOutOfRange)) return 0;
  const double raw = kScale / (std::max(mm, 0.0) + kOffset);
  return static_cast<std::uint16_t>(std::min(raw + 0.5, 4095.0));
}

std::string hdt_text(const robot::RobotModel& model) {
  const robot::DriveModel& drive = model.drive;
  const double top = drive.max_wheel_speed * drive.wheel_diameter / 2;
  std::string text = "# A simulated board: see firmware-stubs/pins/README.md\n";
  text += fmt::format("EYEBOT {}\n", model.name.empty() ? "robot" : model.name);
  for (const int motor : {1, 2}) {
    text += fmt::format("MOTOR {}\nENCODER {} {:.0f}\n", motor, motor, ticks_per_metre(drive));
  }
  for (const robot::RangeSensorModel& sensor : model.range_sensors) {
    if (sensor.id >= 1 && sensor.id <= kPsds) {
      text += fmt::format("PSD {} PSD_Table\n", sensor.id);
    }
  }
  for (const int servo : {1, 2}) text += fmt::format("SERVO {} 1000 2000\n", servo);
  text += fmt::format("DRIVE {:.0f} {:.0f} 0 0\n", m_to_mm(drive.wheel_base), top * 100);
  text += "TABLE PSD_Table\n";
  for (std::size_t raw = 0; raw < kTable.size(); ++raw) {
    text += fmt::format("{}{}", kTable[raw], raw % 16 == 15 ? '\n' : ' ');
  }
  return text + "END TABLE\n";
}

}  // namespace eyebridge::pins
