#pragma once

#include <memory>

#include "eyebridge/hal/registry.hpp"

namespace eyebridge::hal {

/// The row "remote" of the table of backends: one of several robots, which the process that
/// started this one has, at the other end of the descriptor that the URL names. Throws ConfigError.
std::unique_ptr<Backend> open_remote_robot(const BackendUrl& url, const BackendContext& context);

}  // namespace eyebridge::hal
