#include "eyebridge/hal/config.hpp"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "config/run_plan.hpp"
#include "config/toml_text.hpp"
#include "config/values.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/trust.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::string_view kPrefix = "EYEBRIDGE_";

using Values = std::map<std::string, ConfigValue, std::less<>>;

bool is_no_setting(std::string_view variable) {
  return variable == kPlanVariable || variable == "EYEBRIDGE_DATA" ||
         variable.starts_with("EYEBRIDGE_TEST_");
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

void put(Values& values, const Setting& setting, ConfigValue value) {
  check_value(setting, value);
  values.insert_or_assign(std::string(setting.key), std::move(value));
}

void put_flag(Values& values, const std::string& key, const std::string& text) {
  const std::string flag = Config::flag_name(key);
  const Setting* setting = find_setting(key);
  if (setting == nullptr) throw unknown_key("setting", key, {flag});
  if (text.find('\n') != std::string::npos) {
    throw ConfigError({flag}, "found a line end in the value, expected one line");
  }
  put(values, *setting, {text, {flag}});
}

void put_variable(Values& values, const std::string& name, const std::string& text) {
  std::string key = name.substr(kPrefix.size());
  std::ranges::transform(key, key.begin(), lower);
  const Setting* setting = find_setting(key);
  if (setting == nullptr || name != Config::variable_name(key)) {
    throw ConfigError({name}, fmt::format("unknown variable, the nearest one is {}",
                                          Config::variable_name(nearest_key(key))));
  }
  put(values, *setting, {text, {name}});
}

/// Throws where a value counts that its file may not ask for.
void check_trust(const Values& values, const Config::Sources& sources) {
  if (!sources.may_ask) return;
  for (const Setting& setting : settings()) {
    const ConfigValue& value = values.at(std::string(setting.key));
    const bool from_file = value.where.line > 0;
    if (!from_file || !has_effect(setting, value.text)) continue;
    if (sources.may_ask(value.where.file, asked_by(setting, value.text))) continue;
    throw ConfigError(
        value.where,
        fmt::format("found {} = {}, which {}{}, or give {}", setting.key, in_quotes(value.text),
                    setting.effect == Setting::Effect::Starts ? "starts a program" : "writes files",
                    how_to_trust(value.where.file), Config::flag_name(setting.key)));
  }
}

}  // namespace

bool has_effect(const Setting& setting, std::string_view text) {
  return setting.effect != Setting::Effect::None && text != setting.fallback &&
         !(setting.key == "player" && text == "none");
}

std::string asked_by(const Setting& setting, const std::string& text) {
  std::error_code no_folder;  // that of the process is gone: the path stays as it is
  const bool is_path = setting.kind == Setting::Kind::Path && !text.empty();
  // Where links lead: they may lead elsewhere later.
  const std::string full = is_path ? std::filesystem::weakly_canonical(
                                         std::filesystem::absolute(text, no_folder), no_folder)
                                         .string()
                                   : text;
  return fmt::format("{} = {}", setting.key, full);
}

std::vector<std::string> asked_by_file(const std::filesystem::path& file) {
  const auto text = read_toml_file(file);
  if (!text) throw ConfigError({file.string()}, "no such file");
  std::vector<std::string> asked;
  for (const TomlEntry& entry : read_toml(*text, file.string())) {
    if (has_effect(*entry.setting, entry.value.text))
      asked.push_back(asked_by(*entry.setting, entry.value.text));
  }
  return asked;
}

Config Config::load(const Sources& sources) {
  Config config;
  config.sources_ = fingerprint(sources);
  Values& values = config.values_;
  for (const Setting& setting : settings()) {
    put(values, setting, {std::string(setting.fallback), {"default"}});
  }
  RunPlan plan;
  if (const auto text = sources.environment.find(kPlanVariable);
      sources.flags.empty() && text != sources.environment.end()) {
    plan = read_run_plan(text->second);
  }
  if (plan.holds_for(config.sources_)) {
    for (auto& [key, value] : plan.values) values.insert_or_assign(key, std::move(value));
    return config;
  }
  for (auto file = sources.toml_files.rbegin(); file != sources.toml_files.rend(); ++file) {
    const auto text = read_toml_file(*file);
    if (!text) continue;
    for (TomlEntry& entry : read_toml(*text, file->string())) {
      values.insert_or_assign(std::string(entry.setting->key), std::move(entry.value));
    }
  }
  for (const auto& [name, text] : sources.environment) {
    if (name.starts_with(kPrefix) && !is_no_setting(name)) put_variable(values, name, text);
  }
  for (const auto& [key, value] : plan.values) {
    if (value.where.file == flag_name(key)) put_flag(values, key, value.text);
  }
  for (const auto& [key, text] : sources.flags) put_flag(values, key, text);
  check_trust(values, sources);
  return config;
}

const ConfigValue& Config::value(std::string_view key) const {
  const auto found = values_.find(key);
  assert(found != values_.end());
  return found->second;
}

bool Config::is_set(std::string_view key) const { return !value(key).text.empty(); }

std::string Config::text(std::string_view key) const { return value(key).text; }

bool Config::boolean(std::string_view key) const {
  return parse_boolean(value(key).text, value(key).where);
}

long long Config::integer(std::string_view key) const {
  return parse_integer(value(key).text, value(key).where);
}

double Config::number(std::string_view key) const {
  return find_setting(key)->kind == Setting::Kind::Duration
             ? parse_duration(value(key).text, value(key).where)
             : parse_number(value(key).text, value(key).where);
}

PixelSize Config::size(std::string_view key) const {
  return parse_size(value(key).text, value(key).where);
}

std::filesystem::path Config::path(std::string_view key) const { return value(key).text; }

Config Config::with(std::string_view key, ConfigValue value) const {
  Config changed = *this;
  changed.values_.insert_or_assign(std::string(key), std::move(value));
  return changed;
}

std::string Config::flag_name(std::string_view key) {
  std::string out = "--";
  for (const char c : key) out += c == '_' ? '-' : c;
  return out;
}

std::string Config::variable_name(std::string_view key) {
  std::string out(kPrefix);
  for (const char c : key) out += upper(c);
  return out;
}

std::string Config::plan() const { return run_plan_text({sources_, values_}); }

std::string Config::sealed_plan() const { return run_plan_text({kAnySources, values_}); }

std::string Config::describe() const {
  std::size_t widest_key = 0;
  std::size_t widest_value = 0;
  for (const Setting& setting : settings()) {
    widest_key = std::max(widest_key, setting.key.size());
    widest_value = std::max(widest_value, value(setting.key).text.size());
  }
  std::string out;
  for (const Setting& setting : settings()) {
    const ConfigValue& read = value(setting.key);
    out += fmt::format("{:<{}} = {:<{}}  # {}\n", setting.key, widest_key, read.text, widest_value,
                       read.where.str());
  }
  return out;
}

}  // namespace eyebridge::hal
