#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace eyebridge::bridges {

/// One line on standard error: the parts of a sentence; lost where it would have to wait. Uses
/// system calls only.
void report(std::initializer_list<std::string_view> parts);

/// True when a process reads standard error from a pipe: it may wait for its end.
bool has_reader();
/// Lets it go on: what is reported from now on is lost.
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
