#include "windows/load_windows.hpp"

#include <filesystem>
#include <utility>

#include <dlfcn.h>

#include "eyebridge/base/own_place.hpp"

namespace eyebridge::robios {

Windows* load_windows(WindowsStart start, std::string& why) {
  const std::filesystem::path file = plugin_folder() / "libeyebridge_gui.so";
  if (!std::filesystem::exists(file)) {
    why = "there is no " + file.string() +
          "; expected EyeBridge built where Qt 6 is installed (qt6-base-dev)";
    return nullptr;
  }
  void* const plugin = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (plugin == nullptr) {
    why = std::string(dlerror()) + "; expected the plug-in that was built with this EyeBridge";
    return nullptr;
  }
  auto* const open = reinterpret_cast<OpenWindows*>(dlsym(plugin, "eyebridge_open_windows"));
  if (open == nullptr) {
    why = file.string() + " has no windows in it; expected the plug-in of this EyeBridge";
    return nullptr;
  }
  // Kept: they live as long as the process.
  static Windows* const windows = open(kWindowsVersion, std::move(start), why);
  return windows;
}

}  // namespace eyebridge::robios
