#pragma once

#include <memory>
#include <string>

#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/config.hpp"
#include "keys.hpp"
#include "screen.hpp"

namespace eyebridge::robios {

class TerminalPanel;

// What a session is made of, by the settings; a mistake in one is a ConfigError where it was made.

/// "robot 2" where the settings say that this process has the program of one of several robots,
/// whose world another process has; else "".
std::string name_among_several(const hal::Config& config);

/// The rows of the screen, and a last one with the labels of the soft keys in brackets, their line
/// ends as '/'.
std::string text_of(const Screen& screen);

/// Keys by the script of the settings; `input`, unless null, is a person's.
std::unique_ptr<Keys> make_keys(const hal::Config& config, int robot, Clock& clock, Screen& screen,
                                std::unique_ptr<KeyInput> input);

/// A person's keys: at the panel, or at the terminal where there is none.
std::unique_ptr<KeyInput> person_at(const TerminalPanel* panel);

}  // namespace eyebridge::robios
