#pragma once

#include <mutex>
#include <string_view>

#include "eyebridge/base/log.hpp"

namespace eyebridge::robios {

/// Messages of at least `lowest` severity to standard error, each behind "eyebridge: ".
class StderrLog final : public LogSink {
 public:
  explicit StderrLog(Severity lowest) : lowest_(lowest) {}
  void write(Severity severity, std::string_view message) override;

 private:
  Severity lowest_;
  std::mutex mutex_;
};

/// "debug", "info", "warning", "error"; anything else is nothing.
bool parse_severity(std::string_view text, Severity& out);

}  // namespace eyebridge::robios
