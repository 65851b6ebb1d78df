#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace eyebridge::gui {

/// A place in a file that a line of output names.
struct Message {
  enum class Severity { Error, Warning, Note };
  Severity severity = Severity::Note;
  std::string file;       ///< As it was written; never empty.
  int line = 0;           ///< From 1.
  int column = 0;         ///< From 1; 0 when none was named.
  std::string text;       ///< What was said of the place; may be empty.
  std::size_t begin = 0;  ///< Where the place stands in the line of output, bytes …
  std::size_t end = 0;    ///< … up to here.
};

/// Finds the place in a line of a compiler's, Python's, the linker's or EyeBridge's output:
/// `FILE:LINE:COLUMN: text`, `FILE:LINE: text`, `File "FILE", line LINE`, `from FILE:LINE,`. A file
/// name with blanks is recognised when it is an absolute one. Nothing when there is no place in the
/// line. `output` is one line without its end, any bytes. Pure; any thread.
std::optional<Message> find_message(std::string_view output);

}  // namespace eyebridge::gui
