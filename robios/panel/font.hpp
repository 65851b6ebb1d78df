#pragma once

#include <cstdint>
#include <span>

#include "eyebridge/base/colour.hpp"

namespace eyebridge::robios {

enum class FontFamily : std::uint8_t { Helvetica, Times, Courier };
enum class FontStyle : std::uint8_t { Normal, Bold, Italics };

/// One typeface in one size, as glyph bitmaps on a fixed grid: every glyph fills one cell.
///
/// Constant data baked at build time; copies refer to it. Any thread.
class Font {
 public:
  /// `size` is one of font_sizes(); any other size is a mistake of ours.
  Font(FontFamily family, FontStyle style, int size);

  [[nodiscard]] int cell_width() const { return cell_width_; }    ///< Pixels.
  [[nodiscard]] int cell_height() const { return cell_height_; }  ///< Pixels.
  /// Coverage of `code` (Latin-1), 0 paper … 255 ink, row by row, cell_width x cell_height bytes.
  /// Control codes give '?'.
  [[nodiscard]] std::span<const std::uint8_t> glyph(std::uint8_t code) const;

 private:
  int cell_width_;
  int cell_height_;
  const std::uint8_t* glyphs_;
};

/// What a pixel shows that the ink covers by 0 … 255: a mixture of both, rounded.
constexpr Rgb inked(Rgb paper, Rgb ink, unsigned coverage) {
  const auto mix = [coverage](unsigned under, unsigned over) {
    return static_cast<std::uint8_t>((under * (255 - coverage) + over * coverage + 127) / 255);
  };
  return {mix(paper.r, ink.r), mix(paper.g, ink.g), mix(paper.b, ink.b)};
}

/// The sizes that LCDSetFontSize() accepts, ascending: 8, 10, 12, 14, 18, 24.
std::span<const int> font_sizes();

}  // namespace eyebridge::robios
