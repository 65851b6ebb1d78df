#pragma once

#include <array>

namespace eyebridge::robios {

/// The cell of a font size, in pixels. About 0.6 by 1.25 of the size, DejaVu Sans Mono's shape.
struct FontGrid {
  int size;
  int width;
  int height;
};

inline constexpr std::array<FontGrid, 6> kFontGrids{
    {{8, 5, 10}, {10, 6, 13}, {12, 7, 15}, {14, 8, 18}, {18, 11, 23}, {24, 14, 30}}};

inline constexpr int kFontStyles = 3;  ///< Normal, bold, italics.

/// Glyphs of a face: ASCII 32..126, then Latin-1 160..255.
inline constexpr int kAsciiGlyphs = 95;
inline constexpr int kGlyphCount = 191;

/// The character that glyph number `glyph` shows.
constexpr unsigned latin1_of_glyph(int glyph) {
  return static_cast<unsigned>(glyph < kAsciiGlyphs ? 32 + glyph : 160 + glyph - kAsciiGlyphs);
}

/// The glyph that shows `code`; that of '?' for control characters.
constexpr int glyph_of_latin1(int code) {
  if (code >= 160 && code <= 255) {
    return kAsciiGlyphs + code - 160;
  }
  return (code >= 32 && code <= 126 ? code : '?') - 32;
}

}  // namespace eyebridge::robios
