#include "sweep/sweep_file.hpp"

#include <filesystem>
#include <functional>

#include <fmt/format.h>

#include "config/toml_ascii.hpp"
#include "config/toml_document.hpp"
#include "config/values.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/trust.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::apps {
namespace {

using hal::TomlDocument;

/// `read(node)` of each value of a list, or of the one value.
std::vector<AxisValue> values_of(const toml::node& node, const TomlDocument& document,
                                 const std::function<AxisValue(const toml::node&)>& read) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return {read(node)};
  if (list->empty()) {
    throw ConfigError(document.place(node), "found an empty list, expected at least one value");
  }
  std::vector<AxisValue> out;
  for (const toml::node& value : *list) out.push_back(read(value));
  return out;
}

/// A text, a number or a truth value, as a program gets to see it.
AxisValue plain_value(const toml::node& node, const TomlDocument& document) {
  const SourceLocation where = document.place(node);
  if (const auto* text = node.as_string()) return {hal::from_ascii(text->get()), where};
  if (const auto* whole = node.as_integer()) return {fmt::format("{}", whole->get()), where};
  if (const auto* number = node.as_floating_point()) {
    return {fmt::format("{}", number->get()), where};
  }
  if (const auto* flag = node.as_boolean()) return {flag->get() ? "true" : "false", where};
  throw ConfigError(where, fmt::format("found {}, expected a text, a number, true or false",
                                       hal::found_type(node)));
}

AxisValue text_value(const toml::node& node, const TomlDocument& document) {
  if (node.is_string()) return plain_value(node, document);
  throw ConfigError(document.place(node),
                    fmt::format("found {}, expected a text in quotes", hal::found_type(node)));
}

/// A program with a slash in its name, from the file's folder.
AxisValue program_value(const toml::node& node, const TomlDocument& document) {
  AxisValue value = text_value(node, document);
  const std::filesystem::path path(value.text);
  if (value.text.find('/') != std::string::npos && path.is_relative()) {
    value.text = (std::filesystem::path(document.file).parent_path() / path).string();
    // Without a folder before it the name would be looked for in PATH.
    if (value.text.find('/') == std::string::npos) value.text = "./" + value.text;
  }
  return value;
}

void read_table(SweepPlan& plan, AxisKind kind, const toml::node& node,
                const TomlDocument& document) {
  const toml::table* table = node.as_table();
  if (table == nullptr) {
    throw ConfigError(document.place(node),
                      fmt::format("found {}, expected a table", hal::found_type(node)));
  }
  for (const auto& [key, entry] : *table) {
    const std::string name = hal::from_ascii(key.str());
    const SourceLocation where = document.place(key.source().begin);
    if (name.empty() || name.find_first_of("={}\n") != std::string::npos) {
      throw ConfigError(where, fmt::format("found the name {}, expected one without '=', braces "
                                           "and line ends",
                                           in_quotes(name)));
    }
    if (kind == AxisKind::Environment && name.starts_with("EYEBRIDGE_")) {
      throw ConfigError(where, fmt::format("found {}, expected the setting itself", name));
    }
    const auto read = [&](const toml::node& value) { return plain_value(value, document); };
    plan.put({kind, name, values_of(entry, document, read)});
  }
}

Axis setting_axis(const hal::Setting& setting, const toml::node& node,
                  const TomlDocument& document) {
  Axis axis{AxisKind::Setting, std::string(setting.key), {}};
  if (setting.key == "seed" && node.is_string()) {
    const AxisValue range = text_value(node, document);
    axis.values = read_range(range.text, range.where);
    return axis;
  }
  axis.values = values_of(node, document, [&](const toml::node& value) {
    hal::ConfigValue read = hal::setting_value(setting, value, document);
    return AxisValue{std::move(read.text), std::move(read.where)};
  });
  return axis;
}

}  // namespace

SweepPlan read_sweep(std::string_view text, const std::string& file) {
  const TomlDocument document = hal::read_toml_document(text, file);
  SweepPlan plan;
  for (const auto& [key, node] : document.table) {
    const std::string name = hal::from_ascii(key.str());
    const auto as_text = [&](const toml::node& value) { return text_value(value, document); };
    const auto as_program = [&](const toml::node& value) { return program_value(value, document); };
    if (name == "program") {
      plan.put({AxisKind::Program, "program", values_of(node, document, as_program)});
    } else if (name == "arguments") {
      const toml::array* list = node.as_array();
      plan.arguments = list != nullptr && list->empty()
                           ? std::vector<AxisValue>{}
                           : values_of(node, document, [&](const toml::node& value) {
                               return plain_value(value, document);
                             });
    } else if (name == "results") {
      const std::filesystem::path folder = std::filesystem::path(file).parent_path();
      const auto results = folder / as_text(node).text;
      if (!is_within(results, folder)) {
        throw ConfigError(as_text(node).where,
                          fmt::format("found {}, expected a file of this one's folder; another "
                                      "place is for you to say: --results",
                                      in_quotes(as_text(node).text)));
      }
      plan.results = results.string();
    } else if (name == "wall_limit") {
      const AxisValue value = plain_value(node, document);
      plan.wall_limit = parse_duration(value.text, value.where);
    } else if (name == "jobs") {
      const AxisValue value = plain_value(node, document);
      plan.jobs = read_jobs(value.text, value.where);
    } else if (name == "environment" || name == "parameters") {
      read_table(plan, name == "environment" ? AxisKind::Environment : AxisKind::Parameter, node,
                 document);
    } else if (const hal::Setting* setting = hal::find_setting(name)) {
      check_can_vary(name, document.place(key.source().begin));
      plan.put(setting_axis(*setting, node, document));
    } else {
      const ConfigError unknown = hal::unknown_key(node.is_table() ? "table" : "key", name,
                                                   document.place(key.source().begin));
      throw ConfigError(unknown.where(), unknown.text() +
                                             "; or program, arguments, results, wall_limit, jobs, "
                                             "[environment], [parameters]");
    }
  }
  return plan;
}

}  // namespace eyebridge::apps
