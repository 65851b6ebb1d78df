#pragma once

#include <memory>

#include "replay/ebrec.hpp"

namespace eyebridge::hal {

/// A robot that has the devices of a recording but nothing behind them: every call fails with
/// Unsupported. What is behind a replay's tap, which never asks it. Its time is virtual.
std::unique_ptr<Backend> make_recorded_robot(const std::vector<RecordedDevice>& devices);

}  // namespace eyebridge::hal
