#pragma once

#include <map>
#include <string>
#include <string_view>

#include "v4l2/video_handle.hpp"

namespace eyebridge::camera {

/// A control's name as URLs have it: letters in lower case and digits, all else one underscore
/// ("White Balance, Automatic": white_balance_automatic). As v4l2-ctl -l shows them.
std::string control_key(std::string_view name);

/// Sets controls by their keys: switches and menus first, for they decide whether others (exposure,
/// white balance) may be set. Values: whole numbers within the control's range; on and off for
/// switches; for menus also the item by its key. Throws ConfigError: a control that is not there
/// (with all that are), a value out of range (with the range), one that only can be read.
void set_controls(const VideoHandle& camera,
                  const std::map<std::string, std::string, std::less<>>& values);

}  // namespace eyebridge::camera
