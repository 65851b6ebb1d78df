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
  // A copy of this thread's own: it stays valid until the thread asks again. Several robots may
  // share a thread: each has its own.
  thread_local std::string of_thread;
  std::string& text = session.runner() != nullptr ? session.own<GivenText>().text : of_thread;
  text = session.last_error();
  return text.c_str();
}
