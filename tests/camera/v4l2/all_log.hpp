#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/log.hpp"

namespace eyebridge::camera::testing {

/// Keeps what was written to it, by severity.
class AllLog final : public LogSink {
 public:
  void write(Severity severity, std::string_view message) override {
    (severity >= Severity::Warning ? warnings : others).emplace_back(message);
  }
  std::vector<std::string> warnings;
  std::vector<std::string> others;
};

}  // namespace eyebridge::camera::testing
