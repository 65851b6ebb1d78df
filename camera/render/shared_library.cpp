#include "render/shared_library.hpp"

#include <dlfcn.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::camera {

SharedLibrary::SharedLibrary(const char* name, const char* package) : name_(name) {
  // Local: LLVM's symbols must not meet those of a program that brings its own.
  handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) {
    const char* reason = dlerror();
    throw ConfigError({"--camera"}, std::string("cannot load ") + name + " (" +
                                        (reason != nullptr ? reason : "unknown reason") +
                                        "); install it with: apt-get install " + package);
  }
}

void* SharedLibrary::find(const char* name) const {
  void* symbol = dlsym(handle_, name);
  if (symbol == nullptr) {
    throw ConfigError({"--camera"}, name_ + " has no function " + name);
  }
  return symbol;
}

}  // namespace eyebridge::camera
