#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace eyebridge::bridges {

/// Writes the parts of a sentence as one line to standard error. Drops the line when the write
/// would block. Uses system calls only.
void report(std::initializer_list<std::string_view> parts);

/// True when standard error is a pipe or a socket: its reader may be waiting for the end of file.
bool has_reader();
/// Gives that reader its end of file; later reports are lost.
void let_reader_go();

/// A number as text, without memory of its own.
class Digits {
 public:
  explicit Digits(std::int64_t number);
  [[nodiscard]] std::string_view view() const { return {text_, size_}; }

 private:
  char text_[24];
  std::size_t size_;
};

}  // namespace eyebridge::bridges
