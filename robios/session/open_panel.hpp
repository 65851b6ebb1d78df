#pragma once

#include <memory>

#include "eyebridge/hal/config.hpp"

namespace eyebridge::robios {

class Screen;
class TerminalPanel;

/// What shows `screen` (lent) by the setting `panel`, not begun yet: `term` the process's terminal,
/// `none` nothing (null), `auto` the terminal where a person sits at one, time is not virtual, and
/// there are no windows.
/// Throws ConfigError for `term` without a terminal.
std::unique_ptr<TerminalPanel> open_panel(const hal::Config& config, const Screen& screen,
                                          bool has_windows);

}  // namespace eyebridge::robios
