#pragma once

#include <string>
#include <string_view>

#include "eyebridge/base/toml_library.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {

/// A TOML text that was read safely whatever it holds, and where its parts stand.
///
/// Texts in `table` are those of the document in ASCII: from_ascii() gives what was written.
struct TomlDocument {
  std::string file;  ///< As messages name it.
  std::string ascii;
  toml::table table;

  /// Where `at`, which the table says, stands in the file.
  [[nodiscard]] SourceLocation place(const toml::source_position& at) const;
  /// Where `node` begins.
  [[nodiscard]] SourceLocation place(const toml::node& node) const {
    return place(node.source().begin);
  }
};

/// Reads `text`, named `file` in messages. Throws ConfigError.
TomlDocument read_toml_document(std::string_view text, const std::string& file);

/// What `node` is, for messages: "a list", "a text".
std::string_view found_type(const toml::node& node);

/// `node` of `document` as a value of `setting`; a relative path is taken from the document's
/// folder. Throws ConfigError when it is of the wrong TOML type, or not allowed by the setting.
ConfigValue setting_value(const Setting& setting, const toml::node& node,
                          const TomlDocument& document);

}  // namespace eyebridge::hal
