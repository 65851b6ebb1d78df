#pragma once

#include <string_view>

#include "eyebridge/base/colour.hpp"

namespace eyebridge::robios {

/// How many colours a terminal can show.
enum class ColourDepth {
  Palette256,  ///< XTerm's: a cube of 6 x 6 x 6 and 24 greys.
  True,        ///< 8 bits a channel.
};

/// What the variables TERM and COLORTERM say ("" when unset): True for COLORTERM=truecolor or 24bit
/// and for terminals named …-direct, else Palette256, which terminals of the last decades have.
ColourDepth colour_depth(std::string_view term, std::string_view colorterm);

/// The number (16..255) of the palette's colour that is nearest to `colour`.
int palette_index(Rgb colour);

}  // namespace eyebridge::robios
