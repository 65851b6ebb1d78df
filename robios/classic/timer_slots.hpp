#pragma once

namespace eyebridge::robios::classic {

/// True while OSAttachTimer() has given out timers. Any thread.
bool timers_attached();

}  // namespace eyebridge::robios::classic
