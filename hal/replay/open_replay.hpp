#pragma once

#include <memory>

#include "eyebridge/hal/registry.hpp"

namespace eyebridge::hal {

/// The row "replay" of the table of backends: `replay:run.ebrec?mode=strict` (or lenient), in
/// virtual time. It has no world and no camera of its own. Throws ConfigError.
std::unique_ptr<Backend> open_replay(const BackendUrl& url, const BackendContext& context);

}  // namespace eyebridge::hal
