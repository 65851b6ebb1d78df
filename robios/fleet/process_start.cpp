#include "process_start.hpp"

#include <cstdlib>
#include <map>

#include <fmt/format.h>

#include "eyebridge/base/exec_words.hpp"
#include "eyebridge/base/own_place.hpp"

namespace eyebridge::robios {
namespace {

namespace fs = std::filesystem;

/// Settings whose default does something else than the same value that somebody chose.
bool is_better_unsaid(const hal::Setting& setting, const hal::ConfigValue& value) {
  return value.is_default() && (setting.key == "camera" || setting.key == "lcd");
}

/// All of them: a file beside the program must not change what all robots live by.
std::map<std::string, std::string> settings_of(const hal::Config& config, std::size_t index,
                                               int descriptor, const fs::path& out) {
  std::map<std::string, std::string> flags;
  for (const hal::Setting& setting : hal::settings()) {
    const hal::ConfigValue& value = config.value(setting.key);
    if (is_better_unsaid(setting, value)) continue;
    const bool is_path = setting.kind == hal::Setting::Kind::Path && !value.text.empty();
    flags[std::string(setting.key)] =
        is_path ? fs::absolute(config.path(setting.key)).string() : value.text;
  }
  flags["hal"] = fmt::format("remote:{}?robot={}", descriptor, index + 1);
  flags["robots"] = "1";
  flags["out"] = out.empty() ? "" : fs::absolute(out).string();
  flags["report"] = "";  // of the world
  flags["panel"] = "none";
  return flags;
}

/// `folder` before what PYTHONPATH names.
std::string python_path(const std::string& folder) {
  const char* const others = std::getenv("PYTHONPATH");
  const std::string rest = others != nullptr ? others : "";
  return rest.empty() || rest == folder ? folder : folder + ":" + rest;
}

}  // namespace

std::vector<std::string> command_of(const fs::path& program,
                                    const std::vector<std::string>& arguments) {
  std::vector<std::string> words;
  if (program.extension() == ".py") {
    // Through our module, so that it is ours even beside another eye.py, and its time from the
    // start.
    words = {"python3", (python_folder() / "eye").string(), program.string()};
  } else {
    // Not one that is looked for in PATH.
    words = {program.has_parent_path() ? program.string() : "./" + program.string()};
  }
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

std::vector<std::string> environment_of(const hal::Config& config, std::size_t index,
                                        int descriptor, const fs::path& out) {
  std::map<std::string, std::string> variables;
  variables["EYEBRIDGE_FLAGS"] =
      hal::Config::flags_variable(settings_of(config, index, descriptor, out));
  variables["EYEBRIDGE_ROBOTS"] = "1";
  if (const fs::path folder = python_folder(); !folder.empty()) {
    variables["PYTHONPATH"] = python_path(folder.string());
  }
  return environment_with(variables);
}

}  // namespace eyebridge::robios
