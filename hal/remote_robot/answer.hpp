#pragma once

#include "calls/interceptor.hpp"
#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

/// What `robot` says to a call of one of its devices, of its "view" or of its "world". Fails as
/// carry_out().
Result<Values> answer(Backend& robot, const Call& call);

}  // namespace eyebridge::hal
