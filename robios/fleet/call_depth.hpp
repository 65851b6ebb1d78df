#pragma once

namespace eyebridge::robios {

/// How many calls of the API the calling thread, or fiber, is in: a crash there may have left
/// something locked.
inline thread_local int call_depth = 0;

/// Counts one call.
class InCall {
 public:
  InCall() { ++call_depth; }
  ~InCall() { --call_depth; }
  InCall(const InCall&) = delete;
  InCall& operator=(const InCall&) = delete;
};

}  // namespace eyebridge::robios
