#pragma once

namespace eyebridge::apps {

/// From now on SIGINT, SIGTERM and SIGHUP only set what stop_asked() says.
void stop_on_signals();
bool stop_asked();

}  // namespace eyebridge::apps
