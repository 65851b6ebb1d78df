#pragma once

#include <filesystem>

#include "gallery_table.hpp"
#include "golden.hpp"

namespace eyebridge::gallery {

/// Compiles the program of `row` with the build tree's wrapper, as its author would, in a folder of
/// its own, runs it there in virtual time and collects what it left behind. lcd.png and map.png are
/// copied to `pictures` unless that is "". Throws std::runtime_error when it does not compile or
/// leaves no results.
Golden run_program_of(const Row& row, const std::filesystem::path& pictures);

}  // namespace eyebridge::gallery
