#include "sources/stderr_log.hpp"

#include <cstdio>
#include <string>

#include "eyebridge/base/log.hpp"

namespace eyebridge::camera {
namespace {

class StderrLog final : public LogSink {
 public:
  void write(Severity severity, std::string_view message) override {
    if (severity < Severity::Warning) return;
    const char* kind = severity == Severity::Warning ? "warning: " : "error: ";
    tell(std::string(kind).append(message));
  }
};

}  // namespace

LogSink& log_or_stderr(LogSink* log) {
  static StderrLog standard_error;
  return log != nullptr ? *log : standard_error;
}

}  // namespace eyebridge::camera
