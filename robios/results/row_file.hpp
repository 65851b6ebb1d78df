#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace eyebridge::robios {

/// A file that gets a row now and then while a program runs. One thread at a time.
///
/// A disk that is full must not stop a robot that drives: the first failure is kept, and nothing is
/// written any more.
class RowFile {
 public:
  /// Throws ConfigError, without a place, when the file cannot be opened.
  explicit RowFile(std::filesystem::path path);

  void add(std::string_view row) noexcept;
  /// Hands all rows to the system.
  void flush() noexcept;
  /// "FILE: why" of the first failure; "" while there is none.
  [[nodiscard]] std::string failure() const;
  [[nodiscard]] bool failed() const { return failure_ != 0; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void note_failure() noexcept;

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  int failure_ = 0;  ///< errno.
};

}  // namespace eyebridge::robios
