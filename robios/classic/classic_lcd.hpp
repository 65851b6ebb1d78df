#pragma once

#include "mono_lcd.hpp"
#include "session.hpp"

namespace eyebridge::robios::classic {

/// The screen of this generation.
MonoLcd& lcd(Session& session);

}  // namespace eyebridge::robios::classic
