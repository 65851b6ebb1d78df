#include "windows/open_windows.hpp"

#include <cstdlib>
#include <mutex>
#include <set>
#include <utility>

#include <signal.h>
#include <unistd.h>

#include "eyebridge/hal/environment.hpp"
#include "generation.hpp"
#include "host.hpp"
#include "windows/load_windows.hpp"

namespace eyebridge::robios {
namespace {

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

Windows* load(std::string& why) {
  // As Ctrl-C does: motors stop, results are written.
  const auto quit = [] { kill(getpid(), SIGTERM); };
  return load_windows(library_folder(), {quit, program_file().filename().string()}, why);
}

bool wants_windows(const hal::Config& config) {
  const std::string& gui = config.text("gui");
  if (gui != "auto") return gui == "on";
  return !config.boolean("fast") && (is_set("DISPLAY") || is_set("WAYLAND_DISPLAY"));
}

}  // namespace

Windows* open_windows(const hal::Config& config, LogSink& log) {
  if (!wants_windows(config)) return nullptr;
  static std::string why;
  static Windows* const windows = load(why);
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

}  // namespace eyebridge::robios
