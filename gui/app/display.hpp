#pragma once

#include <string>

namespace eyebridge::gui {

/// Whether Qt will find a display: where it does not, it ends the process. False, and `why`.
bool display_can_be_reached(std::string& why);

}  // namespace eyebridge::gui
