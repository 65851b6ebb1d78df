#include "setting_flags.hpp"

#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

namespace eyebridge::apps {
namespace {

std::string_view kind_name(hal::Setting::Kind kind) {
  using Kind = hal::Setting::Kind;
  switch (kind) {
    case Kind::Text:
      return "TEXT";
    case Kind::NumberOrText:
      return "NUMBER|TEXT";
    case Kind::Path:
      return "PATH";
    case Kind::Boolean:
      return "";
    case Kind::Integer:
      return "INTEGER";
    case Kind::Number:
      return "NUMBER";
    case Kind::Duration:
      return "TIME";
    case Kind::Size:
      return "WIDTHxHEIGHT";
  }
  return "";
}

/// What --help and the completion of shells know of a value.
constexpr std::pair<std::string_view, std::string_view> kTypes[] = {
    {"hal", "BACKEND"}, {"world", "WORLD"}, {"camera", "CAMERA"}, {"out", "FOLDER"}};

std::string help_of(const hal::Setting& setting) {
  std::string help(setting.help);
  if (!setting.fallback.empty()) help += " [" + std::string(setting.fallback) + "]";
  return help;
}

void add_flag(CLI::App& command, SettingFlags& flags, const hal::Setting& setting) {
  const std::string key(setting.key);
  const bool is_boolean = setting.kind == hal::Setting::Kind::Boolean;
  const bool is_gui = key == "gui";
  const auto store = [&flags, key, is_boolean, is_gui](const CLI::results_t& values) {
    // A flag without a value arrives with an empty one.
    const bool alone = values.back().empty();
    flags[key] = alone && is_boolean ? "true" : alone && is_gui ? "on" : values.back();
    return true;
  };
  std::string names = hal::Config::flag_name(setting.key);
  if (setting.key == "world") names += ",--sim";
  CLI::Option* option = command.add_option(names, store, help_of(setting));
  option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  option->type_name(setting_type(setting));
  if (is_boolean || is_gui) {
    // "--fast" alone is true; another value needs "--fast=false", for the next word is the program.
    option->type_size(0)->expected(0, 1);
  }
  if (is_gui) {
    command.add_flag_callback(
        "--no-gui", [&flags, key] { flags[key] = "off"; }, "No windows: --gui=off");
  }
}

}  // namespace

std::string setting_type(const hal::Setting& setting) {
  if (!setting.choices.empty()) return std::string(setting.choices);
  for (const auto& [key, type] : kTypes) {
    if (key == setting.key) return std::string(type);
  }
  return std::string(kind_name(setting.kind));
}

void add_setting_flags(CLI::App& command, SettingFlags& flags) {
  for (const hal::Setting& setting : hal::settings()) add_flag(command, flags, setting);
}

}  // namespace eyebridge::apps
