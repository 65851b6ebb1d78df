// `./prog` with --robots (EYEBRIDGE_ROBOTS, eyebridge.toml): before its main() the program becomes
// the launcher, which runs it once for each robot; `python3 prog.py` when it imports `eye`.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <unistd.h>

#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "eyebridge_host.h"
#include "generation.hpp"
#include "host.hpp"
#include "program_threads.hpp"

namespace eyebridge::robios {
namespace {

/// True when the process's program is a robot's, linked with this library, so that its main() is
/// still to come; false in an interpreter, which loads the library later, and in the launcher.
bool belongs_to_program(const char* library) {
  const std::string name = std::filesystem::path(library).filename().string();
  link_map* map = nullptr;
  void* const program = dlopen(nullptr, RTLD_NOW);
  if (program == nullptr || dlsym(program, "eyebridge_calls") != nullptr) return false;
  if (dlinfo(program, RTLD_DI_LINKMAP, &map) != 0) return false;
  const char* names = nullptr;
  for (const ElfW(Dyn)* entry = map->l_ld; entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_STRTAB) names = reinterpret_cast<const char*>(entry->d_un.d_ptr);
  }
  for (const ElfW(Dyn)* entry = map->l_ld; names != nullptr && entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_NEEDED && name == names + entry->d_un.d_val) return true;
  }
  return false;
}

struct Wanted {
  bool several = false;
  bool virtual_time = false;  ///< Of an only robot.
};

Wanted wanted() {
  try {
    const hal::Config config = hal::Config::from_process(program_file());
    const std::string hal = config.text("hal");
    const bool is_simulated = hal == "sim" || hal.starts_with("remote:");
    return {hal::programs_wanted(config) > 1, is_simulated && config.boolean("fast")};
  } catch (const ConfigError&) {
    return {};  // the first RoBIOS call reports it
  }
}

/// Becomes the launcher, for `words`.
[[noreturn]] void start(std::vector<std::string> words) {
  try {
    become_launcher(false, std::move(words));
  } catch (const ConfigError& error) {
    tell(error.what());
    _exit(1);
  }
}

__attribute__((constructor)) void start_several(int argc, char** argv, char** /*environment*/) {
  Dl_info library{};
  if (dladdr(reinterpret_cast<void*>(&start_several), &library) == 0) return;
  if (argc < 1 || !belongs_to_program(library.dli_fname)) return;
  const Wanted settings = wanted();
  if (settings.virtual_time) expect_virtual_time();
  if (!settings.several) return;
  std::vector<std::string> words{program_file().string()};
  words.insert(words.end(), argv + 1, argv + argc);
  start(std::move(words));
}

}  // namespace
}  // namespace eyebridge::robios

void EYEBRIDGEHostStart(int argc, const char* const* argv, const char* interpreter) {
  using namespace eyebridge::robios;
  if (argc < 1 || !wanted().several) return;
  const std::string folder = std::filesystem::path(interpreter).parent_path().string();
  const char* const path = std::getenv("PATH");
  // As activating a virtual environment does.
  if (!folder.empty()) setenv("PATH", (folder + ":" + (path != nullptr ? path : "")).c_str(), 1);
  start({argv, argv + argc});
}
