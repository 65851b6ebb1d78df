#pragma once

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::testing {

/// A device on a pseudo-terminal, in a thread of its own.
class PtyDevice {
 public:
  /// `answer` gets what came since its last answer, after each byte; an empty one waits for more.
  explicit PtyDevice(std::function<std::string(const std::string& came)> answer)
      : answer_(std::move(answer)) {
    int far = -1;
    int near = -1;
    std::array<char, 128> name{};
    if (::openpty(&far, &near, name.data(), nullptr, nullptr) != 0) {
      throw std::runtime_error("no pty");
    }
    far_.reset(far);
    near_.reset(near);
    name_ = name.data();
    thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
  }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  void serve(const std::stop_token& stop) {
    std::string came;
    while (!stop.stop_requested()) {
      pollfd entry{far_.get(), POLLIN, 0};
      if (::poll(&entry, 1, 10) <= 0) continue;
      char byte = 0;
      if (::read(far_.get(), &byte, 1) != 1) continue;
      came += byte;
      const std::string reply = answer_(came);
      if (reply.empty()) continue;
      EXPECT_EQ(::write(far_.get(), reply.data(), reply.size()),
                static_cast<ssize_t>(reply.size()));
      came.clear();
    }
  }

  std::function<std::string(const std::string&)> answer_;
  UniqueFd far_;
  UniqueFd near_;  // so that the line stays open
  std::string name_;
  std::jthread thread_;
};

}  // namespace eyebridge::testing
