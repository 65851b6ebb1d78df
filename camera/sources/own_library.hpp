#pragma once

namespace eyebridge::camera {

/// The function `entry` of a plug-in of ours, opened now: programs that need no OpenCV do not load
/// it. `file` is its name ("libeyebridge_vision.so") in plugin_folder(). It stays loaded. Throws
/// ConfigError with the loader's reason.
void* own_library_entry(const char* file, const char* entry);

}  // namespace eyebridge::camera
