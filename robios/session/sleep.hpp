#pragma once

#include <dlfcn.h>
#include <time.h>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::robios {

class Session;

/// The session of the calling program that is about to wait, when its clock is not the wall clock;
/// else null. Begins it where it will be.
Session* sleepers_session();

/// A hundred years at most.
Time duration_of(const timespec& time);

/// The C library's own.
template <class Function>
Function* next_of(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace eyebridge::robios
