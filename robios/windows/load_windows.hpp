#pragma once

#include <filesystem>
#include <string>

#include "windows/windows.hpp"

namespace eyebridge::robios {

/// The windows of this process, from the plug-in that lies in `folder`, beside our libraries. Once
/// a process. Null, and `why` in words that end in what was expected, where there can be none.
Windows* load_windows(const std::filesystem::path& folder, WindowsStart start, std::string& why);

}  // namespace eyebridge::robios
