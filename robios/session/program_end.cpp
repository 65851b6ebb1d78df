// The end of a program, before the first of its exit handlers: windows stay until they are closed,
// and Qt has handlers of its own, which come before ours.

#include <cstdlib>

#include <dlfcn.h>

#include "session.hpp"

namespace {

using eyebridge::robios::Session;
using Main = int(int, char**, char**);

Main* the_main = nullptr;

int run_main(int argc, char** argv, char** environment) {
  const int code = the_main(argc, argv, environment);
  Session::program_ends(code);
  return code;
}

/// The C library's own.
template <class Function>
Function* next(const char* name) {
  void* const found = dlsym(RTLD_NEXT, name);
  if (found == nullptr) abort();  // it has both
  return reinterpret_cast<Function*>(found);
}

}  // namespace

// Programs that are linked with us find these before the C library's.
extern "C" {

__attribute__((visibility("default"))) void exit(int code) noexcept {
  Session::program_ends(code);
  next<void(int)>("exit")(code);
  abort();  // it does not return
}

// NOLINTNEXTLINE(readability-identifier-naming): the C library's
__attribute__((visibility("default"))) int __libc_start_main(Main* main, int argc, char** argv,
                                                             void (*init)(), void (*fini)(),
                                                             void (*loader_fini)(),
                                                             void* stack_end) {
  the_main = main;
  using Start = int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*);
  return next<Start>("__libc_start_main")(run_main, argc, argv, init, fini, loader_fini, stack_end);
}

}  // extern "C"
