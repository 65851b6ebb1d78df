#include "gallery_table.hpp"

#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "eyebridge/base/toml_library.hpp"

namespace eyebridge::gallery {
namespace {

[[noreturn]] void reject(const toml::node& node, const std::string& what) {
  const toml::source_region& at = node.source();
  throw std::runtime_error("programs.toml:" + std::to_string(at.begin.line) + ": " + what);
}

[[noreturn]] void reject_value(const toml::node& node, std::string_view expected) {
  std::ostringstream what;
  node.visit([&](const auto& value) { what << "found " << value; });
  what << ", expected " << expected;
  reject(node, what.str());
}

/// What programs.toml calls a value of this type.
template <class Value>
constexpr std::string_view kKind = std::is_same_v<Value, bool> ? "true or false" : "a string";

template <class Value>
void take(const toml::node& node, Value& out) {
  const auto value = node.value_exact<Value>();
  if (!value) reject_value(node, kKind<Value>);
  out = *value;
}

void take(const toml::node& node, std::vector<std::string>& out) {
  const toml::array* list = node.as_array();
  if (list == nullptr) reject_value(node, "a list of strings");
  for (const toml::node& entry : *list) take(entry, out.emplace_back());
}

Row read_row(const std::string& name, const toml::table& table) {
  Row row;
  row.name = name;
  for (const auto& [key, node] : table) {
    if (key == "source") {
      take(node, row.source);
    } else if (key == "world") {
      take(node, row.world);
    } else if (key == "keys") {
      take(node, row.keys);
    } else if (key == "time_limit") {
      take(node, row.time_limit);
    } else if (key == "arguments") {
      take(node, row.arguments);
    } else if (key == "files") {
      take(node, row.files);
    } else if (key == "classic") {
      take(node, row.classic);
    } else if (key == "camera") {
      take(node, row.camera);
    } else if (key == "threads") {
      take(node, row.threads);
    } else if (key == "tolerance") {
      row.tolerance = node.value<double>().value_or(-1.0);
      if (row.tolerance < 0.0) reject_value(node, "a number from 0");
    } else {
      reject(node,
             "found the key '" + std::string(key.str()) + "', expected one of the first lines");
    }
  }
  if (row.source.empty())
    reject(table, "found no source of " + name + ", expected a file or a folder");
  return row;
}

}  // namespace

void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }

std::vector<Row> read_table(const std::filesystem::path& file) {
  std::vector<Row> rows;
  for (const auto& [name, node] : toml::parse_file(file.string())) {
    const toml::table* table = node.as_table();
    if (table == nullptr) reject_value(node, "a table for each program");
    rows.push_back(read_row(std::string(name.str()), *table));
  }
  return rows;
}

}  // namespace eyebridge::gallery
