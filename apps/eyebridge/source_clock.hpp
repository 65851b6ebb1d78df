#pragma once

#include <memory>
#include <string>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::apps {

/// The clock by which a command takes frames from the camera source `url`: the computer's time for
/// live cameras; for all others virtual time that moves only by waiting, so that no frame is missed
/// however long one is looked at.
std::unique_ptr<Clock> clock_for(const std::string& url);

}  // namespace eyebridge::apps
