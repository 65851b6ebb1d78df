#pragma once

#include <memory>
#include <vector>

#include "calls/device_list.hpp"

namespace eyebridge::hal {

/// A robot that has `devices` but nothing behind them: every call fails with Unsupported. What is
/// behind an interceptor that answers by itself. Its time is virtual. Throws ConfigError without a
/// place for a device that does not exist.
std::unique_ptr<Backend> make_absent_robot(const std::vector<ListedDevice>& devices);

}  // namespace eyebridge::hal
