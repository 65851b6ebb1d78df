#include <cstdlib>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "config/run_plan.hpp"
#include "eyebridge/base/trust.hpp"
#include "eyebridge/files/search.hpp"
#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/world_file.hpp"

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

/// Without flags.
Config::Sources sources_of_process(const std::filesystem::path& program) {
  Config::Sources sources;
  sources.process = getpid();
  sources.environment = process_environment();
  sources.toml_files = {kFileName};
  if (program.has_parent_path()) {
    sources.toml_files.push_back(program.parent_path() / kFileName);
  }
  if (const auto user = user_file(sources.environment); !user.empty()) {
    sources.toml_files.push_back(user);
  }
  sources.may_ask = [](const std::string& file, const std::string& asked) {
    return is_users_own(file) || Trust::of_user().covers(file, asked);
  };
  return sources;
}

struct Written {
  std::string name;
  std::filesystem::path folder;  ///< Of the file that it is written in; empty: of none.
};

/// The reader of a TOML file has put its folder in front of a relative path.
Written as_written(const ConfigValue& world) {
  const std::filesystem::path folder = std::filesystem::path(world.where.file).parent_path();
  if (world.where.line > 0 && !folder.empty()) {
    std::string name = std::filesystem::path(world.text).lexically_relative(folder).string();
    if (!name.empty() && !name.starts_with("..")) return {std::move(name), folder};
  }
  return {world.text, {}};
}

}  // namespace

bool is_users_own(const std::string& file) { return file == user_file(process_environment()); }

std::string world_file(const ConfigValue& world, const std::filesystem::path& program) {
  std::error_code error;
  if (std::filesystem::exists(world.text, error)) return world.text;
  const Written written = as_written(world);
  const auto places = files::SearchPlaces::of_process(program);
  const auto found = files::try_find_file(written.name, written.folder, places);
  return found ? found->string() : world.text;
}

std::filesystem::path find_world(const ConfigValue& world, const std::filesystem::path& program) {
  std::error_code error;
  if (std::filesystem::exists(world.text, error)) return world.text;
  const Written written = as_written(world);
  return files::find_file(written.name, written.folder, files::SearchPlaces::of_process(program),
                          world.where);
}

Config Config::from_process(const std::filesystem::path& program) {
  return of_program(program, sources_of_process(program));
}

Config Config::from_command_line(const std::filesystem::path& program,
                                 const std::map<std::string, std::string>& flags) {
  Sources sources = sources_of_process(program);
  sources.environment.erase(kPlanVariable);
  sources.flags = flags;
  return of_program(program, sources);
}

void Config::keep_outputs() const {
  RunPlan inherited{"of the parent", values_};  // to others it is one of flags
  for (const Setting& setting : settings()) {
    if (setting.effect != Setting::Effect::Writes) continue;
    const std::string name = variable_name(setting.key);
    // What stands in the folder's file would count for others, too: they read it anew.
    if (value(setting.key).where.line > 0) {
      ::setenv(name.c_str(), std::string(setting.fallback).c_str(), 1);
    } else {
      ::unsetenv(name.c_str());
    }
    inherited.values.erase(std::string(setting.key));
  }
  if (std::getenv(kPlanVariable) == nullptr) return;
  ::setenv(kPlanVariable, run_plan_text(inherited).c_str(), 1);
}

Config Config::of_program(const std::filesystem::path& program, const Sources& sources) {
  Config config = load(sources);
  config.program_ = program;
  ConfigValue& world = config.values_.at("world");
  if (!world.text.empty()) world.text = world_file(world, program);
  return config;
}

}  // namespace eyebridge::hal
