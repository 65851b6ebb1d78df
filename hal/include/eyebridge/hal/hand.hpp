#pragma once

#include "eyebridge/hal/registry.hpp"

namespace eyebridge::hal {

/// Throws ConfigError, at the setting that is wrong, when a person could not drive `backend`, which
/// was opened without the setting `drive`, as that setting of `context` wants: a robot without a
/// camera, no walls for markers, a camera that cannot be had. Opens nothing; does nothing when the
/// setting is unset.
void check_hand(const BackendContext& context, Backend& backend);

}  // namespace eyebridge::hal
