#pragma once

#include <string>

namespace eyebridge::camera {

/// A shared library opened at run time, so that programs without a camera never load it.
///
/// It stays loaded until the process ends: Mesa and LLVM leave exit handlers behind.
class SharedLibrary {
 public:
  /// Opens `name` ("libOSMesa.so.8"). Throws ConfigError naming `package`, the apt package that has
  /// it, when that fails.
  SharedLibrary(const char* name, const char* package);

  /// The function `name` as `Function`, a pointer to function. Throws ConfigError when it is
  /// absent.
  template <class Function>
  [[nodiscard]] Function get(const char* name) const {
    return reinterpret_cast<Function>(find(name));
  }

 private:
  [[nodiscard]] void* find(const char* name) const;

  std::string name_;
  void* handle_ = nullptr;
};

}  // namespace eyebridge::camera
