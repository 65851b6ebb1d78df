#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/toml_document.hpp"
#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal {

/// A table of a mapping file, whose entries are taken one after the other: what is wrong with one
/// is a ConfigError at its place.
class DbcFields {
 public:
  /// `name` is what messages call the table: "[wheels]". All must outlive this.
  DbcFields(const toml::table& table, const TomlDocument& document, std::string name)
      : table_(table), document_(document), name_(std::move(name)) {}

  [[nodiscard]] bool has(std::string_view key);
  /// Nothing where there is no such entry.
  std::optional<std::string> text(std::string_view key);
  std::optional<double> number(std::string_view key, double least, double most);
  std::optional<long> whole(std::string_view key, long least, long most);
  std::optional<bool> flag(std::string_view key);
  std::optional<Time> duration(std::string_view key);
  const toml::table* table(std::string_view key);
  const toml::array* list(std::string_view key);
  /// They must be there.
  std::string need_text(std::string_view key, std::string_view what);
  const toml::table& need_table(std::string_view key);

  /// Refuses entries that were not taken.
  void finish() const;
  /// Where the entry is; else the table.
  [[nodiscard]] SourceLocation place(std::string_view key) const;
  [[noreturn]] void refuse(std::string_view key, const std::string& text) const;
  [[nodiscard]] const TomlDocument& document() const { return document_; }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  const toml::node* get(std::string_view key);
  [[noreturn]] void wrong_type(std::string_view key, const toml::node& node,
                               std::string_view expected) const;

  const toml::table& table_;
  const TomlDocument& document_;
  std::string name_;
  std::vector<std::string> known_;
};

/// "; nearest: 'Left', 'Right'" of the names that look most like `wanted`; all where they are few,
/// nothing where there are none.
std::string nearest_names(std::string_view wanted, std::vector<std::string> names);

}  // namespace eyebridge::hal
