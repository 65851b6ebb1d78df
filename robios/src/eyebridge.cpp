#include "eyebridge.h"

#include <string>

#include "session.hpp"

const char* EYEBRIDGELastError(void) {
  // A copy of this thread's own: it stays valid until the thread asks again.
  thread_local std::string text;
  text = eyebridge::robios::Session::instance().last_error();
  return text.c_str();
}
