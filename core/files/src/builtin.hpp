#pragma once

#include <span>
#include <string_view>

namespace eyebridge::files {

/// A file of worlds/robots/, put into the library by CMake.
struct BuiltinText {
  std::string_view file;  ///< "worlds/robots/S4.robi"
  std::string_view text;
};

std::span<const BuiltinText> builtin_texts();

/// "S4, S4-2015, LabBot, Mouse, Car, Omni, ServoBot, ServoBot-11, Mako or USAL"
std::string_view builtin_names();

}  // namespace eyebridge::files
