#pragma once

#include <filesystem>
#include <string_view>

namespace eyebridge::apps {

/// True for Python text with a function `run(robot, keep_going, belief_space, map_space, interact)`
/// at its top level: a control file, which eyebridge.control runs, not a robot program.
bool is_control_text(std::string_view text);

/// The same of the file `program`; false for one that cannot be read.
bool is_control_file(const std::filesystem::path& program);

}  // namespace eyebridge::apps
