#pragma once

#include <string>

namespace eyebridge::camera {

/// Name of what renders pictures here without a display: "osmesa" or "egl". Tries it out. Throws
/// ConfigError that says why nothing does.
std::string renderer_here();

}  // namespace eyebridge::camera
