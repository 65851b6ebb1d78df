#pragma once

#include <optional>
#include <string_view>

#include "eyebridge/world/world_model.hpp"

namespace eyebridge::files {

/// The built-in object of this name, case ignored, at the origin: "can", "soccer", "golf", "crate".
std::optional<world::ObjectSpec> builtin_object(std::string_view name);

}  // namespace eyebridge::files
