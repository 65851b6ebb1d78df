#include <unistd.h>

#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {
namespace {

constexpr const char* kFileName = "eyebridge.toml";

std::map<std::string, std::string> process_environment() {
  std::map<std::string, std::string> out;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view line = *entry;
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos) {
      out.emplace(line.substr(0, equals), line.substr(equals + 1));
    }
  }
  return out;
}

/// The XDG base directory specification: relative folders in XDG_CONFIG_HOME do not count.
std::filesystem::path user_file(const std::map<std::string, std::string>& environment) {
  const auto xdg = environment.find("XDG_CONFIG_HOME");
  if (xdg != environment.end() && std::filesystem::path(xdg->second).is_absolute()) {
    return std::filesystem::path(xdg->second) / "eyebridge" / kFileName;
  }
  const auto home = environment.find("HOME");
  if (home == environment.end() || home->second.empty()) return {};
  return std::filesystem::path(home->second) / ".config" / "eyebridge" / kFileName;
}

}  // namespace

Config Config::from_process(const std::filesystem::path& program) {
  Sources sources;
  sources.environment = process_environment();
  sources.toml_files = {kFileName};
  if (program.has_parent_path()) {
    sources.toml_files.push_back(program.parent_path() / kFileName);
  }
  if (const auto user = user_file(sources.environment); !user.empty()) {
    sources.toml_files.push_back(user);
  }
  return load(sources);
}

}  // namespace eyebridge::hal
