#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/radio.hpp"

namespace eyebridge::robios {

/// Messages that a program has been told of and has not received: a radio hands each over once, and
/// programs want to know first whether there is one. Any thread.
class RadioMessages {
 public:
  /// Who sent the oldest one; nobody when none waits.
  Result<std::optional<int>> first_sender(hal::Radio& radio) {
    const std::lock_guard lock(mutex_);
    return fetch(radio).map([&]() -> std::optional<int> {
      if (messages_.empty()) return std::nullopt;
      return messages_.front().sender;
    });
  }
  Result<std::size_t> count(hal::Radio& radio) {
    const std::lock_guard lock(mutex_);
    return fetch(radio).map([&] { return messages_.size(); });
  }
  /// The oldest one.
  Result<std::optional<hal::RadioMessage>> take(hal::Radio& radio) {
    const std::lock_guard lock(mutex_);
    return fetch(radio).map([&]() -> std::optional<hal::RadioMessage> {
      if (messages_.empty()) return std::nullopt;
      std::optional<hal::RadioMessage> first = std::move(messages_.front());
      messages_.pop_front();
      return first;
    });
  }
  void clear() {
    const std::lock_guard lock(mutex_);
    messages_.clear();
  }

 private:
  Result<void> fetch(hal::Radio& radio) {
    for (;;) {
      auto message = radio.receive();
      if (!message) return tl::unexpected(message.error());
      if (!*message) return {};
      messages_.push_back(std::move(**message));
    }
  }

  std::mutex mutex_;
  std::deque<hal::RadioMessage> messages_;
};

class Session;

/// The radio of the session's robot; Unsupported when it has none.
Result<hal::Radio*> radio_of(Session& session);

/// The oldest message, for the function `call`; waits by `wait_until`, on the robot's clock. A
/// program that waits in virtual time for what nobody can send is ended.
Result<hal::RadioMessage> wait_for_message(Session& session, hal::Radio& radio,
                                           std::string_view call,
                                           const std::function<void(Time)>& wait_until);

}  // namespace eyebridge::robios
