#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::files {

/// EyeSim's description of an object (`.esObj`): a disc that covers its colliders from above. One
/// that is a single sphere is a ball. `name` is what it is called when the file gives no name.
/// Throws ConfigError.
world::ObjectSpec read_object(std::string_view text, const std::string& file,
                              const std::string& name, std::vector<Warning>& warnings);

}  // namespace eyebridge::files
