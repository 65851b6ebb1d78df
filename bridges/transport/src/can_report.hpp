#pragma once

#include <optional>
#include <string>

#include "eyebridge/bridges/can_bus.hpp"

namespace eyebridge::bridges {

/// Counts an error frame, a report of the controller as in linux/can/error.h, in `statistics`.
/// Returns the error for receive() when it says that `bus` cannot be used any more: bus-off.
std::optional<Error> note_report(const CanFrame& report, CanStatistics& statistics,
                                 const std::string& bus);

/// The error for send() while the controller is off the bus.
Error bus_off_error(const std::string& bus);

}  // namespace eyebridge::bridges
