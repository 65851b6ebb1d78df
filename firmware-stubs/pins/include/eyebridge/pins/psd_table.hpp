#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::pins {

/// What a distance sensor of the simulated boards means by a raw value: millimetres for each of
/// 0 … 4095, out of range as 9999. The only place where this curve is written down.
///
/// It is the hyperbola of Sharp's infrared sensors (GP2D12 and kin: voltage ~ 1 / (distance + c)),
/// stretched so that it falls from 0 mm on without their fold below 100 mm and reaches as far as
/// the simulated sensors do: raw = 2 047 500 / (mm + 500). A step of raw is 0.3 mm at 0.3 m,
/// 1 mm at 1 m and 3 mm at 2 m.
std::span<const std::uint16_t, 4096> psd_table();

/// The raw value that the table takes for `range` metres; 0 for what is out of its reach.
std::uint16_t psd_raw(double range);

/// An HDT file for a host that drives `model` through a simulated board: encoders, PSDs with the
/// table, servos, drive.
std::string hdt_text(const robot::RobotModel& model);

}  // namespace eyebridge::pins
