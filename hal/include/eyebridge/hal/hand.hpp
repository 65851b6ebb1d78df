#pragma once

#include "eyebridge/hal/registry.hpp"

namespace eyebridge::hal {

/// Throws ConfigError, at the setting that is wrong, when a person could not drive `backend`, which
/// was opened without the setting `drive`, as that setting of `context` wants: a robot without a
/// camera, no walls for markers, a camera that cannot be had. Opens nothing; does nothing when the
/// setting is unset.
void check_hand(const BackendContext& context, Backend& backend);

/// A camera that the user asked for must be possible; one that nobody mentioned may be missing
/// until the program wants it. `backend`, whose world it may show, is null where it is not open.
/// Throws ConfigError.
void check_camera(const Config& config, Backend* backend, LogSink& log);

}  // namespace eyebridge::hal
