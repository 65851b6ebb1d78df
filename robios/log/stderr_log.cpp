#include "log/stderr_log.hpp"

#include <array>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/log.hpp"

namespace eyebridge::robios {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"debug", "info", "warning", "error"};

}  // namespace

void StderrLog::write(Severity severity, std::string_view message) {
  if (severity < lowest_) return;
  const std::lock_guard lock(mutex_);
  // Info speaks for itself; what went wrong says how bad it is.
  const bool plain = severity == Severity::Info;
  const std::string_view name = plain ? "" : kNames[static_cast<std::size_t>(severity)];
  tell(fmt::format("{}{}{}{}", who_, name, plain ? "" : ": ", message));
}

Severity lowest_severity(const hal::Config& config) {
  const hal::ConfigValue& wanted = config.value("log");
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == wanted.text) return static_cast<Severity>(i);
  }
  throw ConfigError(
      wanted.where,
      fmt::format("'{}' is no log level; expected debug, info, warning or error", wanted.text));
}

}  // namespace eyebridge::robios
