#pragma once

#include <memory>

#include "eyebridge/files/scenario.hpp"
#include "eyebridge/hal/registry.hpp"

namespace eyebridge::hal {

/// The row "sim" of the table of backends: robot 1 of the world that the configuration names, or of
/// an empty room, with what the computer adds to it. Others can join it: Backend::shared_world().
/// Throws ConfigError.
std::unique_ptr<Backend> open_sim(const BackendUrl& url, const BackendContext& context);

/// Robot 1 of a scenario at hand, named `where` in messages; without what the computer adds.
std::unique_ptr<Backend> open_scenario(files::Scenario scenario, const SourceLocation& where,
                                       const BackendContext& context);

}  // namespace eyebridge::hal
