#pragma once

#include <optional>
#include <string_view>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/fiducials.hpp"

namespace eyebridge::hal {

/// What the setting `drive` says.
struct HandSetting {
  bool is_free = false;                 ///< Without markers.
  camera::FiducialLayout layout;        ///< As the sheet was printed.
  std::optional<double> field_of_view;  ///< Of a camera that is not calibrated, radians.

  friend bool operator==(const HandSetting&, const HandSetting&) = default;
};

/// "hand", "hand?size=60mm&spacing=0.4m&height=10cm&family=tag36h11&fov=66" (degrees), or
/// "hand:free". Throws ConfigError at `where`.
HandSetting parse_hand(std::string_view text, const SourceLocation& where);

}  // namespace eyebridge::hal
