#pragma once

#include <string>
#include <vector>

#include "calls/interceptor.hpp"
#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

/// A device that a robot has, and what it says about itself without a call.
struct ListedDevice {
  std::string kind;  ///< As in Call.
  int id = 1;
  /// A psd's out_of_range(); a lidar's max_range(), field of view, tilt and points; a radio's id();
  /// else nothing.
  Values facts;

  friend bool operator==(const ListedDevice&, const ListedDevice&) = default;
};

/// What the robot has, asked device by device: a backend has no list.
std::vector<ListedDevice> devices_of(Backend& backend);

}  // namespace eyebridge::hal
