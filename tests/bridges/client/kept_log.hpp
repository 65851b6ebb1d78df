#pragma once

#include <mutex>
#include <string>

#include "eyebridge/base/log.hpp"

namespace eyebridge::bridges::testing {

/// Keeps what was logged, one line each.
class KeptLog final : public LogSink {
 public:
  void write(Severity, std::string_view message) override {
    const std::lock_guard lock(mutex_);
    text_ += std::string(message) + '\n';
  }
  [[nodiscard]] std::string text() const {
    const std::lock_guard lock(mutex_);
    return text_;
  }

 private:
  mutable std::mutex mutex_;
  std::string text_;
};

}  // namespace eyebridge::bridges::testing
