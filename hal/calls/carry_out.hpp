#pragma once

#include "calls/interceptor.hpp"
#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

/// The other way round than an interceptor: does what `call` says to that device of `robot`, and
/// gives its answer as numbers. Unsupported for a device that the robot has not and for a call that
/// there is not, Corrupt for a request that is not of that call's length. Serial ports and sound
/// are of the computer, not of the robot: Unsupported.
Result<Values> carry_out(Backend& robot, const Call& call);

}  // namespace eyebridge::hal
