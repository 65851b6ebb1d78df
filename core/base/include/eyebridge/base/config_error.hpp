#pragma once

#include <stdexcept>
#include <string>

namespace eyebridge {

/// A place in a text file. Lines and columns count from 1; 0 means "not known".
struct SourceLocation {
  std::string file;  ///< Path, or a name for text that has none: "--keys", "EYEBRIDGE_WORLD".
  int line = 0;
  int column = 0;

  /// "maze.maz:14:7", or as much of it as is known.
  [[nodiscard]] std::string str() const;

  friend bool operator==(const SourceLocation&, const SourceLocation&) = default;
};

/// A mistake in something the user wrote: a file, a flag, a URL. Thrown only while opening.
class ConfigError : public std::runtime_error {
 public:
  /// `text` says what was found and what was expected.
  ConfigError(SourceLocation where, const std::string& text);

  [[nodiscard]] const SourceLocation& where() const { return where_; }
  /// The message without its place.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  SourceLocation where_;
  std::string text_;
};

/// Something odd in a file that is still read: named, never silent.
struct Warning {
  SourceLocation where;
  std::string text;

  /// "maze.maz:3:4: warning: …"
  [[nodiscard]] std::string str() const;
};

}  // namespace eyebridge
