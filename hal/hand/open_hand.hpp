#pragma once

#include <memory>

#include "eyebridge/hal/registry.hpp"

namespace eyebridge::hal {

/// `backend` as the setting `drive` wants it: itself when that is unset. Opens the camera of the
/// setting `camera` unless hand:free. Throws ConfigError as check_hand(), and as
/// camera::open_source.
std::unique_ptr<Backend> with_hand(std::unique_ptr<Backend> backend, const BackendContext& context);

}  // namespace eyebridge::hal
