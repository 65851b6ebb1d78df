#pragma once

#include <string_view>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::robios {

/// What `call` ("PSDGet") takes on a real robot, from the table in costs.cpp; virtual clocks
/// advance by it, so that a program that only polls still sees time pass. Never zero.
Time cost_of(std::string_view call);

}  // namespace eyebridge::robios
