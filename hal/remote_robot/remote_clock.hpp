#pragma once

#include <memory>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal {

class RobotLine;

/// The robot's time at the program's end of its line, which is lent and has been welcomed: virtual,
/// or real and `factor` times as fast as the wall clock.
std::unique_ptr<Clock> make_remote_clock(RobotLine& line, bool is_virtual, double factor);

}  // namespace eyebridge::hal
