#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <signal.h>
#include <unistd.h>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/files/search.hpp"
#include "windows/load_windows.hpp"

namespace eyebridge::apps {
namespace {

/// A world may be named as in a run.
std::filesystem::path named_file(const std::string& file) {
  return files::try_find_file(file, {}, files::SearchPlaces::of_process()).value_or(file);
}

[[noreturn]] void edit(const std::vector<std::string>& names) {
  std::string why;
  robios::Windows* const windows =
      robios::load_windows({[] { kill(getpid(), SIGTERM); }, "eyebridge"}, why);
  if (windows == nullptr) throw ConfigError({"edit"}, "no windows can be opened: " + why);
  for (const std::string& file : names)
    windows->edit(std::filesystem::absolute(named_file(file)).string());
  if (names.empty()) windows->edit("");
  windows->finish("");
  // Edits are on the disk and windows are gone. Threads that Qt has for pictures are not, and now
  // and then what they do on the process's way out meets what Qt cleans up there: that is left out.
  std::fflush(nullptr);
  std::_Exit(kFine);
}

}  // namespace

void add_edit(CLI::App& root) {
  CLI::App* command = root.add_subcommand(
      "edit", "Opens worlds and programs in windows: edit [FILE...]; a new world without a file");
  const auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("files", *files, "Worlds (.wld, .maz, .sim) and programs (.c, .cpp, .py)")
      ->type_name("FILE");
  command->callback([files] { edit(*files); });
}

}  // namespace eyebridge::apps
