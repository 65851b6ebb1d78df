#include "eyebridge.h"

#include <string>

#include "session.hpp"

namespace {

/// The text that the robot's program was given last.
struct GivenText {
  std::string text;
};

}  // namespace

const char* EYEBRIDGELastError(void) {
  using eyebridge::robios::Session;
  Session& session = Session::instance();
  // A copy of this thread's own: it stays valid until the thread asks again. In virtual time
  // several robots share a thread: each has its own.
  thread_local std::string of_thread;
  const bool shares = session.runner() != nullptr && session.clock().is_virtual();
  std::string& text = shares ? session.own<GivenText>().text : of_thread;
  text = session.last_error();
  return text.c_str();
}
