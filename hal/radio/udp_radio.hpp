#pragma once

#include <memory>

#include "eyebridge/base/log.hpp"
#include "radio/radio_inbox.hpp"
#include "radio/radio_setting.hpp"

namespace eyebridge::hal {

/// The radio of robot `id` among robots of other processes: UDP multicast as `setting` says. While
/// it is on, a thread "eb:radio" listens and tells others once a second that this robot is there;
/// robots that were not heard of for three seconds are gone. start() fails with Disconnected where
/// the network does not allow it, and takes 0.1 s: so long the others have to answer. A second
/// robot with the same number is warned of once. `clock`, of the robot, and `log` are lent.
std::unique_ptr<Radio> make_udp_radio(const RadioSetting& setting, int id,
                                      const RadioErrors& errors, Clock& clock, LogSink& log);

}  // namespace eyebridge::hal
