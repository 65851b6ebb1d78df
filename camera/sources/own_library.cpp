#include "sources/own_library.hpp"

#include <string>

#include <dlfcn.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_place.hpp"

namespace eyebridge::camera {

void* own_library_entry(const char* file, const char* entry) {
  const auto path = plugin_folder() / file;
  // Local: the symbols of OpenCV must not meet those of a program that brings its own.
  if (void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (void* found = dlsym(library, entry)) return found;
  }
  const char* reason = dlerror();
  throw ConfigError({"--camera"}, std::string("cannot load ") + file + ": " +
                                      (reason != nullptr ? reason : "unknown") +
                                      "; OpenCV's libraries bring it: apt-get install "
                                      "libopencv-contrib-dev libopencv-videoio-dev");
}

}  // namespace eyebridge::camera
