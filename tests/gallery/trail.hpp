#pragma once

#include <string_view>

#include "golden.hpp"

namespace eyebridge::gallery {

/// What trace.csv tells, in few lines: where the robot ended and how far it went, and some twenty
/// poses on its way (s, mm, degrees). Without the way when `end_only`.
Lines trail_lines(std::string_view trace_csv, bool end_only);

}  // namespace eyebridge::gallery
