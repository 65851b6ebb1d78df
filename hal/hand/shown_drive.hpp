#pragma once

#include <memory>

#include "eyebridge/hal/backend.hpp"
#include "hand/instruction.hpp"

namespace eyebridge::hal {

/// `inner` as it is, but that `display` shows what its drive was told, and how far it is with it by
/// its odometry: a person follows it with a camera where there are no markers to see.
std::unique_ptr<Backend> with_shown_drive(std::unique_ptr<Backend> inner,
                                          std::unique_ptr<InstructionSink> display);

}  // namespace eyebridge::hal
