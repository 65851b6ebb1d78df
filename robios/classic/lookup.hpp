#pragma once

#include <array>
#include <string_view>

#include "eyebot.h"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/backend.hpp"

namespace eyebridge::robios::classic {

/// The number by which `backend` knows the device of `kind` ("psd", "motor", …) that a program
/// means.
///
/// `semantics` is a number, or the address of a name (all that does not fit into an int). What the
/// robot's file says comes first, the name before the number, as most numbers in our header are not
/// those of the original; where it says nothing about the kind,
/// the standard names count: PSD_FRONT, _LEFT, _RIGHT, _BACK are 1 … 4 (those between, 5 on),
/// motors and encoders 1 left and 2 right, SERVO7 is 7, and the M6's names "PSD0", "ENCODER0" …
/// count from 0. OutOfRange when there is none. Any thread.
Result<int> find_device(hal::Backend& backend, std::string_view kind, DeviceSemantics semantics);

/// The motors of the VW drive, left and right: those that the robot's description calls so (a
/// submarine's are 1 and 3), else 1 and 2. Any thread.
std::array<int, 2> vw_motors(hal::Backend& backend);

/// "-205 (PSD_LEFT)", "\"PSD0\"": for messages.
std::string describe(DeviceSemantics semantics);

/// The number of classic RoBIOS that belongs to what may be a name; UNKNOWN_SEMANTICS when none
/// does.
DeviceSemantics number_of(DeviceSemantics semantics);

}  // namespace eyebridge::robios::classic
