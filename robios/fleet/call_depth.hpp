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

/// In a call, where the robot's program goes on: in its timers' functions, or where its threads wait
/// for each other.
class OutOfCall {
 public:
  OutOfCall() : depth_(call_depth) { call_depth = 0; }
  ~OutOfCall() { call_depth = depth_; }
  OutOfCall(const OutOfCall&) = delete;
  OutOfCall& operator=(const OutOfCall&) = delete;

 private:
  const int depth_;
};

}  // namespace eyebridge::robios
