#pragma once

#include <string_view>

namespace eyebridge {

enum class Severity { Debug, Info, Warning, Error };

/// Where messages go. Passed in; implementations lock for themselves, so any thread may write.
class LogSink {
 public:
  virtual ~LogSink() = default;
  /// One message, one line, without a line end.
  virtual void write(Severity severity, std::string_view message) = 0;
};

/// Swallows everything: for tests and benchmarks.
class NullLog final : public LogSink {
 public:
  void write(Severity, std::string_view) override {}
};

/// One message to the user on standard error: "eyebridge: ", `text` as printable() makes it, and a
/// line end, in one write where the system takes that. All messages go this way. Any thread.
void tell(std::string_view text);

}  // namespace eyebridge
