#pragma once

#include <memory>

#include "eyebridge/hal/registry.hpp"

namespace eyebridge::hal {

/// Throws ConfigError, at the setting that is wrong, for what `config` alone shows: a bad text
/// under "drive"; a person and no simulated robot, no world, other motors, or no real camera.
void check_drive(const Config& config);

/// `backend` as the setting `drive` wants it: itself when that is unset. Opens the camera of the
/// setting `camera` unless hand:free. Throws ConfigError as check_hand(), and as
/// camera::open_source.
std::unique_ptr<Backend> with_hand(std::unique_ptr<Backend> backend, const BackendContext& context);

}  // namespace eyebridge::hal
