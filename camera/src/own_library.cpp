#include "src/own_library.hpp"

#include <filesystem>
#include <string>

#include <dlfcn.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::camera {
namespace {

namespace fs = std::filesystem;

/// The folder of the program or library that this function is linked into.
fs::path own_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&own_folder), &info) == 0) return ".";
  std::error_code error;
  const fs::path here = fs::canonical(info.dli_fname, error);
  // A program that was found by PATH is known by its bare name only.
  return (error ? fs::read_symlink("/proc/self/exe", error) : here).parent_path();
}

}  // namespace

void* own_library_entry(const char* file, const char* entry) {
  const fs::path folder = own_folder();
  std::string reasons;
  for (const fs::path& path : {folder / file, folder.parent_path() / "lib" / file}) {
    // Local: the symbols of OpenCV must not meet those of a program that brings its own.
    if (void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
      if (void* found = dlsym(library, entry)) return found;
    }
    const char* reason = dlerror();
    reasons += std::string(reasons.empty() ? "" : "; ") + (reason != nullptr ? reason : "unknown");
  }
  throw ConfigError({"--camera"}, std::string("cannot load ") + file + ": " + reasons);
}

}  // namespace eyebridge::camera
