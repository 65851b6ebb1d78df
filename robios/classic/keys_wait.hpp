#pragma once

#include "eyebridge/base/result.hpp"
#include "session.hpp"

namespace eyebridge::robios::classic {

/// Waits for a key of `mask` while timers and, where permitted, other tasks run, and returns it.
/// Ends the program when no key can come any more. OutOfRange for a mask without a key.
Result<int> wait_for_key(Session& session, int mask);

}  // namespace eyebridge::robios::classic
