#include "windows/open_windows.hpp"

#include <cstdlib>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/hal/environment.hpp"
#include "windows/load_windows.hpp"

namespace eyebridge::robios {
namespace {

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// Only what is watched has windows unless somebody says so.
bool wants_windows(const hal::Config& config) {
  const std::string& gui = config.text("gui");
  if (gui != "auto") return gui == "on";
  return !config.boolean("fast") && (is_set("DISPLAY") || is_set("WAYLAND_DISPLAY"));
}

}  // namespace

Windows* open_windows(const hal::Config& config, LogSink& log, WindowsStart start) {
  if (!wants_windows(config)) return nullptr;
  static std::string why;
  static Windows* const windows = load_windows(std::move(start), why);
  if (windows != nullptr) return windows;
  if (config.text("gui") == "on") {
    throw ConfigError(config.value("gui").where,
                      "no windows can be opened: " + why + ", or gui = off");
  }
  log.write(Severity::Info, "no windows: " + why);
  return nullptr;
}

void show_world(Windows& windows, hal::Environment& environment, Crew* crew) {
  static std::mutex mutex;
  static std::set<hal::Environment*> shown;
  const std::lock_guard lock(mutex);
  if (!shown.insert(&environment).second) return;
  if (environment.starts_paused()) environment.time().pause();
  windows.open_environment(environment, crew);
}

void tell_of_ignored_pause(const hal::Environment& environment, LogSink& log) {
  if (!environment.starts_paused()) return;
  log.write(Severity::Info,
            "the world asks to start paused: ignored, as there is no window that could resume it");
}

}  // namespace eyebridge::robios
