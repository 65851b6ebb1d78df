#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "eyebridge/base/hash.hpp"
#include "eyebridge/base/pose.hpp"
#include "radio/radio_inbox.hpp"

namespace eyebridge::hal {

/// Where a robot is now, in its world; nothing where nobody knows. Any thread.
using RadioPlace = std::function<std::optional<Vec2>()>;

/// The air between the robots of one world: as many radios as the process has robots share one.
/// They live on the same clock. Any thread.
///
/// What a robot receives, and in which order, follows from when it was sent and by whom, and from
/// the seed: in virtual time every run is the same.
class RadioMedium {
 public:
  RadioMedium() = default;
  RadioMedium(const RadioMedium&) = delete;
  RadioMedium& operator=(const RadioMedium&) = delete;

  /// The robot listens from now on, and messages to it suffer `errors`; once more forgets nothing.
  /// `place` is for ranges: without it, or the sender's, the robot is in range of everyone.
  void join(int id, const RadioErrors& errors, const RadioPlace& place = {});
  void leave(int id);
  /// To all others when `receiver` is kEveryone.
  void send(int receiver, const RadioMessage& message, Time now);
  std::optional<RadioMessage> take(int id, Time now);
  /// Of all that was received until now: who, when, what.
  [[nodiscard]] std::uint64_t trace_value();
  /// Who listens, ascending.
  std::vector<int> robots();

 private:
  struct Member {
    RadioInbox inbox;
    RadioPlace place;
  };
  /// `sender` is null when it does not listen itself.
  static bool reaches(const Member* sender, const Member& receiver);

  std::mutex mutex_;
  StateHash trace_;
  std::map<int, Member> members_;
};

/// The radio of robot `id` in `medium`, whose messages to it suffer `errors`; `clock` is lent.
std::unique_ptr<Radio> make_medium_radio(std::shared_ptr<RadioMedium> medium, int id,
                                         const RadioErrors& errors, Clock& clock,
                                         RadioPlace place = {});

}  // namespace eyebridge::hal
