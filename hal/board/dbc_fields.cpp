#include "board/dbc_fields.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "config/toml_ascii.hpp"
#include "eyebridge/base/text.hpp"

namespace eyebridge::hal {

std::string nearest_names(std::string_view wanted, std::vector<std::string> names) {
  constexpr std::size_t kMost = 3;
  constexpr std::size_t kLongest = 200;  // of a name whose distance is worth its time
  if (names.empty() || wanted.size() > kLongest) return "";
  std::erase_if(names, [](const std::string& name) { return name.size() > kLongest; });
  std::ranges::stable_sort(names, {},
                           [&](const std::string& name) { return edit_distance(name, wanted); });
  names.resize(std::min(names.size(), kMost));
  std::string out;
  for (const std::string& name : names)
    out += (out.empty() ? "; nearest: " : ", ") + in_quotes(name);
  return out;
}

const toml::node* DbcFields::get(std::string_view key) {
  known_.emplace_back(key);
  return table_.get(key);
}

bool DbcFields::has(std::string_view key) { return get(key) != nullptr; }

SourceLocation DbcFields::place(std::string_view key) const {
  const toml::node* const node = table_.get(key);
  return node == nullptr ? document_.place(table_) : document_.place(*node);
}

void DbcFields::refuse(std::string_view key, const std::string& text) const {
  throw ConfigError(place(key), text);
}

void DbcFields::wrong_type(std::string_view key, const toml::node& node,
                           std::string_view expected) const {
  throw ConfigError(document_.place(node), fmt::format("found {} for '{}' in {}, expected {}",
                                                       found_type(node), key, name_, expected));
}

std::optional<std::string> DbcFields::text(std::string_view key) {
  const toml::node* const node = get(key);
  if (node == nullptr) return std::nullopt;
  const auto* const text = node->as_string();
  if (text == nullptr) wrong_type(key, *node, "a text in quotes");
  return from_ascii(text->get());
}

std::optional<double> DbcFields::number(std::string_view key, double least, double most) {
  const toml::node* const node = get(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->value<double>();
  if (!node->is_number() || !value) wrong_type(key, *node, "a number");
  if (!(*value >= least && *value <= most)) {
    refuse(key, fmt::format("found {} for '{}' in {}, expected {} … {}", *value, key, name_, least,
                            most));
  }
  return value;
}

std::optional<long> DbcFields::whole(std::string_view key, long least, long most) {
  const toml::node* const node = get(key);
  if (node == nullptr) return std::nullopt;
  const auto* const value = node->as_integer();
  if (value == nullptr) wrong_type(key, *node, "a whole number");
  if (value->get() < least || value->get() > most) {
    refuse(key, fmt::format("found {} for '{}' in {}, expected {} … {}", value->get(), key, name_,
                            least, most));
  }
  return static_cast<long>(value->get());
}

std::optional<bool> DbcFields::flag(std::string_view key) {
  const toml::node* const node = get(key);
  if (node == nullptr) return std::nullopt;
  const auto* const value = node->as_boolean();
  if (value == nullptr) wrong_type(key, *node, "true or false");
  return value->get();
}

std::optional<Time> DbcFields::duration(std::string_view key) {
  const toml::node* const node = get(key);
  if (node == nullptr) return std::nullopt;
  double seconds = 0;
  if (const auto* const text = node->as_string()) {
    seconds = parse_duration(from_ascii(text->get()), document_.place(*node));
  } else if (node->is_number()) {
    seconds = node->value<double>().value_or(0);
  } else {
    wrong_type(key, *node, "a duration such as \"20ms\", or a number of seconds");
  }
  constexpr double kLongest = 3600;
  if (!(seconds >= 1e-3 && seconds <= kLongest)) {
    refuse(key, fmt::format("found {} s for '{}' in {}, expected 1 ms … 1 h", seconds, key, name_));
  }
  return from_seconds(seconds);
}

const toml::table* DbcFields::table(std::string_view key) {
  const toml::node* const node = get(key);
  if (node == nullptr) return nullptr;
  if (!node->is_table()) wrong_type(key, *node, "a table");
  return node->as_table();
}

const toml::array* DbcFields::list(std::string_view key) {
  const toml::node* const node = get(key);
  if (node == nullptr) return nullptr;
  if (!node->is_array()) wrong_type(key, *node, fmt::format("a list: [[{}]]", key));
  for (const toml::node& entry : *node->as_array()) {
    if (!entry.is_table()) wrong_type(key, entry, fmt::format("tables: [[{}]]", key));
  }
  return node->as_array();
}

std::string DbcFields::need_text(std::string_view key, std::string_view what) {
  auto found = text(key);
  if (!found) refuse(key, fmt::format("found no '{}' in {}, expected {}", key, name_, what));
  return *std::move(found);
}

const toml::table& DbcFields::need_table(std::string_view key) {
  const toml::table* const found = table(key);
  if (found == nullptr) refuse(key, fmt::format("found no '{}' in {}, expected it", key, name_));
  return *found;
}

void DbcFields::finish() const {
  for (const auto& [key, node] : table_) {
    const std::string name = from_ascii(key.str());
    if (std::ranges::find(known_, key.str()) != known_.end()) continue;
    throw ConfigError(document_.place(key.source().begin),
                      fmt::format("found {} in {}, expected another name{}", in_quotes(name), name_,
                                  nearest_names(name, known_)));
  }
}

}  // namespace eyebridge::hal
