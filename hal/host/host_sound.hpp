#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/hal/sound.hpp"

namespace eyebridge::hal {

/// Sounds that nobody hears: each takes its length on `clock`, which is lent.
std::unique_ptr<Sound> make_silent_sound(Clock& clock);

/// Sounds by a player of this computer, a program that gets the file as its last argument. `player`
/// is its command line, or "auto": the first one in PATH that can play the format. `path` is
/// the variable PATH. Where there is none, sounds fail with Unsupported, in words for people.
std::unique_ptr<Sound> make_played_sound(std::string player, std::string path);

/// The program `name` in the folders of `path`, or "".
std::string find_in_path(const std::string& name, std::string_view path);

}  // namespace eyebridge::hal
