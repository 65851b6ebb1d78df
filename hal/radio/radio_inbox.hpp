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
  Time jitter{0};        ///< Up to so much more delay, evenly spread.
  double corrupt = 0.0;  ///< Share in which one bit is flipped, 0 … 1.
  double range = 0.0;    ///< Metres beyond which nothing arrives; 0: no limit.
};

/// Messages on their way to one robot, in an order that does not depend on who put them in first:
/// by arrival, then by sender, then as they were sent. One thread.
class RadioInbox {
 public:
  /// What does not fit any more is lost.
  static constexpr std::size_t kMost = 4096;

  RadioInbox(int id, const RadioErrors& errors) : id_(id), errors_(errors) {}

  [[nodiscard]] const RadioErrors& errors() const { return errors_; }

  /// `message` was sent at `now`, from out of range if `in_range` is false. What it suffers follows
  /// from the seed, sender, receiver and how many this sender has sent before; each kind of error
  /// draws for every message, from a stream of its own.
  void add(RadioMessage message, Time now, bool in_range = true) {
    auto [entry, is_new] =
        links_.try_emplace(message.sender, Link(errors_.seed, stream_of(message.sender)));
    Link& link = entry->second;
    const std::uint64_t number = link.sent++;
    const bool lost = link.loss.chance(errors_.loss);
    const auto late = Time(static_cast<Time::rep>(link.jitter.uniform() *
                                                  static_cast<double>(errors_.jitter.count())));
    const bool corrupted = link.corruption.chance(errors_.corrupt);
    const std::uint64_t place = link.corruption.bits();
    if (lost || !in_range || waiting_.size() >= kMost) return;
    if (corrupted && !message.text.empty()) {
      const std::uint64_t bit = place % (8 * message.text.size());
      char& byte = message.text[bit / 8];
      byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << (bit % 8)));
    }
    waiting_.emplace(std::tuple(now + errors_.delay + late, message.sender, number),
                     std::move(message));
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
    Link(std::uint64_t seed, std::uint64_t stream)
        : loss(seed, stream), jitter(seed, stream | kJitter), corruption(seed, stream | kCorrupt) {}
    // Above the bits that stream_of() sets.
    static constexpr std::uint64_t kJitter = 1U << 16U;
    static constexpr std::uint64_t kCorrupt = 2U << 16U;
    Random loss;
    Random jitter;
    Random corruption;
    std::uint64_t sent = 0;
  };
  /// A stream of random numbers for each pair, apart from those of devices
  /// (fault/fault_injector.cpp).
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
