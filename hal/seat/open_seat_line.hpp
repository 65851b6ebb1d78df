#pragma once

#include <memory>

#include "eyebridge/hal/registry.hpp"

namespace eyebridge::hal {

/// The row "seat" of the table of backends: one of several robots, whose seat the process that
/// started this one has, at the other end of the descriptor that the URL names. Throws ConfigError.
std::unique_ptr<Backend> open_seat_line(const BackendUrl& url, const BackendContext& context);

}  // namespace eyebridge::hal
