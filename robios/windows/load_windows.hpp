#pragma once

#include <string>

#include "windows/windows.hpp"

namespace eyebridge::robios {

/// The windows of this process, from the plug-in libeyebridge_gui.so. Once a process. Null, and
/// `why` in words that end in what was expected, where there can be none.
Windows* load_windows(WindowsStart start, std::string& why);

}  // namespace eyebridge::robios
