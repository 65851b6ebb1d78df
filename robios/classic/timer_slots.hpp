#pragma once

#include "session.hpp"

namespace eyebridge::robios::classic {

/// True while OSAttachTimer() has given out timers of this robot. Any thread.
bool timers_attached(Session& session);

}  // namespace eyebridge::robios::classic
