#include "eyebridge/base/trust.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command.hpp"
#include "eyebridge/base/one_line.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/files/scenario_programs.hpp"
#include "eyebridge/hal/config.hpp"
#include "sweep_plan.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSettings = "eyebridge.toml";

std::vector<std::string> asked_by_sweep_file(const fs::path& file) {
  SweepPlan plan = make_plan({}, {file.string()});
  find_programs(plan);
  std::vector<std::string> out;
  for (Asked& asked : asked_by(plan)) out.push_back(std::move(asked.text));
  return out;
}

std::vector<std::string> asked_by_file(const fs::path& file) {
  if (file.filename() == kSettings) return hal::asked_by_file(file);
  if (file.extension() == ".toml") return asked_by_sweep_file(file);
  if (file.extension() == ".sim") {
    return files::asked_by(files::load_scenario(file, {.reading = files::Reading::Tolerant}), file);
  }
  throw ConfigError({file.string()},
                    "found another file, expected eyebridge.toml, a .sim file, a "
                    "sweep file (.toml), or a folder");
}

/// Of a folder: its settings and its scenarios.
std::vector<fs::path> files_of(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw ConfigError({path.string()}, "no such file or folder");
  if (!fs::is_directory(path, error)) return {path};
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(path)) {
    const fs::path& file = entry.path();
    if (file.filename() == kSettings || file.extension() == ".sim") out.push_back(file);
  }
  std::ranges::sort(out);
  return out;
}

void print(const fs::path& file, const std::vector<std::string>& asked) {
  // A line each, whatever is in them.
  fmt::print("{}\n", printable(escaped(file.string())));
  for (const std::string& text : asked) fmt::print("  {}\n", printable(escaped(text)));
}

void trust(const fs::path& path) {
  const std::vector<fs::path> all = files_of(path);
  bool asks = false;
  for (const fs::path& file : all) {
    const std::vector<std::string> asked = asked_by_file(file);
    if (asked.empty()) continue;
    Trust::of_user().give(file, asked);
    print(file, asked);
    asks = true;
  }
  if (!asks) fmt::print("{} asks for nothing that needs trust\n", printable(path.string()));
}

void take_back(const fs::path& path) {
  // What was trusted may be gone by now.
  const auto trusted = Trust::of_user().entries();
  std::size_t count = 0;
  for (const Trust::Entry& entry : trusted) {
    std::error_code error;
    const fs::path meant_path = fs::weakly_canonical(fs::absolute(path), error);
    const bool meant = meant_path == entry.file || is_within(entry.file, meant_path);
    if (!meant || !Trust::of_user().take_back(entry.file)) continue;
    fmt::print("{}: not trusted any more\n", printable(entry.file.string()));
    ++count;
  }
  if (count == 0) throw ConfigError({path.string()}, "found nothing that is trusted");
}

}  // namespace

void add_trust(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand(
      "trust", "Lets files of a folder start programs and write files: eyebridge trust [PATH]");
  command->footer(
      "A folder's eyebridge.toml may not write files (out, report, record) or start programs\n"
      "(player), and its .sim and sweep files may not start programs outside of the folder,\n"
      "until you have looked at them and said so. PATH is such a file, or a folder: its\n"
      "eyebridge.toml and .sim files. Prints what is trusted; when the file asks for something\n"
      "else later, you are asked again. Settings of flags, variables and\n"
      "~/.config/eyebridge/eyebridge.toml need no trust.");
  auto path = std::make_shared<std::string>(".");
  auto list = std::make_shared<bool>(false);
  auto revoke = std::make_shared<bool>(false);
  command->add_option("PATH", *path, "File or folder")->capture_default_str();
  CLI::Option* const listing = command->add_flag("--list", *list, "Shows all that is trusted");
  command->add_flag("--revoke", *revoke, "Trusts it no more")->excludes(listing);
  command->callback([path, list, revoke, &code] {
    if (*list) {
      for (const Trust::Entry& entry : Trust::of_user().entries()) print(entry.file, entry.asked);
    } else if (*revoke) {
      take_back(*path);
    } else {
      trust(*path);
    }
    code = kFine;
  });
}

}  // namespace eyebridge::apps
