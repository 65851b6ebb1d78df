#pragma once

namespace eyebridge::camera {

/// The function `entry` of a library of ours that lies beside us, opened now: what needs OpenCV is
/// not loaded by programs that do without. `file` is its name ("libeyebridge_vision.so"), searched
/// where the code of this function lies, then in ../lib of that place. It stays loaded. Throws
/// ConfigError saying where it was searched.
void* own_library_entry(const char* file, const char* entry);

}  // namespace eyebridge::camera
