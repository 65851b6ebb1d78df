#pragma once

#include <memory>
#include <vector>

#include "tap/device_list.hpp"

namespace eyebridge::hal {

/// A robot that has `devices` but nothing behind them: every call fails with Unsupported. What is
/// behind a tap that answers by itself. Its time is virtual. Throws ConfigError without a place for
/// a device that does not exist.
std::unique_ptr<Backend> make_absent_robot(const std::vector<ListedDevice>& devices);

}  // namespace eyebridge::hal
