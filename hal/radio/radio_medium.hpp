#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "radio/radio_inbox.hpp"

namespace eyebridge::hal {

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
  void join(int id, const RadioErrors& errors);
  void leave(int id);
  /// To all others when `receiver` is kEveryone.
  void send(int receiver, const RadioMessage& message, Time now);
  std::optional<RadioMessage> take(int id, Time now);
  /// Who listens, ascending.
  std::vector<int> robots();

 private:
  std::mutex mutex_;
  std::map<int, RadioInbox> inboxes_;
};

/// The radio of robot `id` in `medium`, whose messages to it suffer `errors`; `clock` is lent.
std::unique_ptr<Radio> make_medium_radio(std::shared_ptr<RadioMedium> medium, int id,
                                         const RadioErrors& errors, Clock& clock);

}  // namespace eyebridge::hal
