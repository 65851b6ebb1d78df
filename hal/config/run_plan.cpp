#include "config/run_plan.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "config/values.hpp"
#include "eyebridge/base/hash.hpp"
#include "eyebridge/base/one_line.hpp"

namespace eyebridge::hal {
namespace {

/// Takes the text before the next `separator` off the front of `text`.
std::string_view take(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

bool read_number(std::string_view text, int& number) {
  const char* const end = text.data() + text.size();
  return std::from_chars(text.data(), end, number).ptr == end && !text.empty();
}

void read_line(RunPlan& plan, std::string_view line, const SourceLocation& where) {
  std::string_view rest = line;
  std::string_view entry = take(rest, '\t');
  const bool has_value = entry.find('=') != std::string_view::npos;
  const std::string key(take(entry, '='));
  ConfigValue value{unescaped(entry), {unescaped(take(rest, '\t'))}};
  if (!has_value || !read_number(take(rest, '\t'), value.where.line) ||
      !read_number(rest, value.where.column)) {
    throw ConfigError(
        where, fmt::format("found {}, expected key=value, file, line and column", in_quotes(line)));
  }
  if (find_setting(key) == nullptr) throw unknown_key("setting", key, where);
  plan.values.insert_or_assign(key, std::move(value));
}

}  // namespace

std::string fingerprint(const Config::Sources& sources) {
  StateHash hash;
  hash.add(static_cast<std::uint64_t>(sources.process));
  const auto add = [&](std::string_view text) {
    for (const char c : text) hash.add_byte(static_cast<std::uint8_t>(c));
    hash.add_byte(0);
  };
  for (const auto& file : sources.toml_files) {
    std::error_code no_folder;  // that of the process is gone: no file is there, either
    add(std::filesystem::absolute(file, no_folder).lexically_normal().string());
  }
  for (const auto& [name, text] : sources.environment) {
    if (name.starts_with("EYEBRIDGE_") && name != kPlanVariable) add(name + "=" + text);
  }
  return fmt::format("{:016x}", hash.value());
}

std::string run_plan_text(const RunPlan& plan) {
  std::string out = plan.sources + '\n';
  for (const auto& [key, value] : plan.values) {
    if (value.is_default()) continue;
    out += fmt::format("{}={}\t{}\t{}\t{}\n", key, escaped(value.text), escaped(value.where.file),
                       value.where.line, value.where.column);
  }
  return out;
}

RunPlan read_run_plan(std::string_view text) {
  RunPlan plan;
  plan.sources = take(text, '\n');
  for (int line = 2; !text.empty(); ++line) {
    read_line(plan, take(text, '\n'), {kPlanVariable, line});
  }
  return plan;
}

}  // namespace eyebridge::hal
