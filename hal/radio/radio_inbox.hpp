#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/hal/radio.hpp"

namespace eyebridge::hal {

/// What messages suffer on their way.
struct RadioErrors {
  double loss = 0.0;  ///< Share that gets lost, 0 … 1.
  Time delay{0};      ///< On the receiver's clock.
  std::uint64_t seed = 1;
};

/// Messages on their way to one robot, in an order that does not depend on who put them in first:
/// by arrival, then by sender, then as they were sent. One thread.
class RadioInbox {
 public:
  /// What does not fit any more is lost.
  static constexpr std::size_t kMost = 4096;

  RadioInbox(int id, const RadioErrors& errors) : id_(id), errors_(errors) {}

  /// `message` was sent at `now`. Whether it gets lost follows from the seed, sender, receiver and
  /// how many this sender has sent before.
  void add(RadioMessage message, Time now) {
    auto [link, is_new] =
        links_.try_emplace(message.sender, Link{Random(errors_.seed, stream_of(message.sender))});
    const std::uint64_t number = link->second.sent++;
    if (link->second.random.chance(errors_.loss) || waiting_.size() >= kMost) return;
    waiting_.emplace(std::tuple(now + errors_.delay, message.sender, number), std::move(message));
  }

  /// The first message that has arrived by `now`.
  std::optional<RadioMessage> take(Time now) {
    const auto first = waiting_.begin();
    if (first == waiting_.end() || std::get<Time>(first->first) > now) return std::nullopt;
    RadioMessage message = std::move(first->second);
    waiting_.erase(first);
    return message;
  }

 private:
  struct Link {
    Random random;
    std::uint64_t sent = 0;
  };
  /// A stream of random numbers for each pair, apart from those of devices (fault/fault_tap.cpp).
  [[nodiscard]] std::uint64_t stream_of(int sender) const {
    constexpr std::uint64_t kRadio = 0x7261'6469'6F00'0000;
    return kRadio + static_cast<std::uint64_t>(sender) * 256 + static_cast<std::uint64_t>(id_);
  }

  const int id_;
  const RadioErrors errors_;
  std::map<int, Link> links_;
  std::map<std::tuple<Time, int, std::uint64_t>, RadioMessage> waiting_;
};

/// OutOfRange for no number of a robot or a text that is too long.
inline Result<void> check_message(int receiver, const std::string& text) {
  const bool is_id = receiver >= Radio::kFirstId && receiver <= Radio::kLastId;
  if (!is_id && receiver != Radio::kEveryone) {
    return fail(Errc::OutOfRange, "radio: got the receiver " + std::to_string(receiver) +
                                      ", expected the number of a robot, 1 … 255");
  }
  if (text.size() <= Radio::kLongestText) return {};
  return fail(Errc::OutOfRange, "radio: got a message of " + std::to_string(text.size()) +
                                    " bytes, expected at most 1024");
}

inline tl::unexpected<Error> radio_is_off() {
  return fail(Errc::Unsupported, "radio: it is off; expected RADIOInit() before");
}

}  // namespace eyebridge::hal
