#pragma once

#include <functional>
#include <memory>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/hal/backend.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::hal {

/// What stands in the world of a remote robot: asked for once, when somebody looks.
using WorldLoader = std::function<std::shared_ptr<const world::WorldModel>()>;

/// The robot whose server `socket` leads to, for its program: everything is asked there. In real
/// time its clock is `factor` times as fast as the wall clock, and it returns when all robots of
/// the world are there (in virtual time Backend::arrive() does). Throws ConfigError without a place
/// when nobody answers.
std::unique_ptr<Backend> make_remote_robot(UniqueFd socket, WorldLoader world, double factor);

}  // namespace eyebridge::hal
