#pragma once

#include <filesystem>

namespace eyebridge {

/// File of the program or shared library that this code is linked into: absolute, symbolic links
/// resolved. Empty if it cannot be found (a relative LD_LIBRARY_PATH after a change of folder).
std::filesystem::path own_binary();

/// Folder of EyeBridge's own data (worlds, examples, ...): `share/eyebridge` in the nearest folder
/// above `binary` that has one. Works in a build tree, an installation, a package and a wheel,
/// which may all be moved. Empty if there is none.
std::filesystem::path share_folder(const std::filesystem::path& binary = own_binary());

/// Folder of what EyeBridge itself loads and starts (plug-ins, launchers): in the nearest folder
/// above `binary` that has it, as share_folder(). Empty if there is none.
std::filesystem::path plugin_folder(const std::filesystem::path& binary = own_binary());

/// Folder that holds EyeBridge's own Python packages and no others, except in a wheel. Empty if
/// there is none.
std::filesystem::path python_folder(const std::filesystem::path& binary = own_binary());

}  // namespace eyebridge
