#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::robios {

/// Messages of at least `lowest` severity to standard error, each behind "eyebridge: " and, where
/// there are several robots, `who`.
class StderrLog final : public LogSink {
 public:
  explicit StderrLog(Severity lowest, std::string who = {})
      : lowest_(lowest), who_(who.empty() ? "" : std::move(who) + ": ") {}
  void write(Severity severity, std::string_view message) override;

 private:
  const Severity lowest_;
  const std::string who_;
  std::mutex mutex_;
};

/// What the setting `log` asks for; ConfigError where it is none of debug, info, warning, error.
Severity lowest_severity(const hal::Config& config);

}  // namespace eyebridge::robios
