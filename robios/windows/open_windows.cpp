#include "windows/open_windows.hpp"

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

#include <dlfcn.h>
#include <signal.h>
#include <unistd.h>

#include "eyebridge/hal/environment.hpp"
#include "generation.hpp"
#include "host.hpp"

namespace eyebridge::robios {
namespace {

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// Null, and why.
Windows* load(std::string& why) {
  const std::filesystem::path file = library_folder() / "libeyebridge_gui.so";
  void* const plugin = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (plugin == nullptr) {
    why = std::string("the plug-in is missing (") + dlerror() + ")";
    return nullptr;
  }
  auto* const open = reinterpret_cast<OpenWindows*>(dlsym(plugin, "eyebridge_open_windows"));
  if (open == nullptr) {
    why = file.string() + " is no plug-in of ours";
    return nullptr;
  }
  // As Ctrl-C does: motors stop, results are written.
  const auto quit = [] { kill(getpid(), SIGTERM); };
  return open(kWindowsVersion, {quit, program_file().filename().string()}, why);
}

}  // namespace

bool wants_windows(const hal::Config& config) {
  const std::string& gui = config.text("gui");
  if (gui != "auto") return gui == "on";
  return !config.boolean("fast") && (is_set("DISPLAY") || is_set("WAYLAND_DISPLAY"));
}

Windows* open_windows(const hal::Config& config, LogSink& log) {
  if (!wants_windows(config)) return nullptr;
  static std::string why;
  static Windows* const windows = load(why);
  if (windows != nullptr) return windows;
  if (config.text("gui") == "on") {
    throw ConfigError(config.value("gui").where,
                      "no windows can be opened: " + why + "; expected a display, or gui = off");
  }
  log.write(Severity::Info, "no windows: " + why);
  return nullptr;
}

void show_world(Windows& windows, hal::Environment& environment) {
  static std::mutex mutex;
  static std::set<hal::Environment*> shown;
  const std::lock_guard lock(mutex);
  if (!shown.insert(&environment).second) return;
  if (environment.starts_paused()) environment.time().pause();
  windows.open_environment(environment);
}

}  // namespace eyebridge::robios
