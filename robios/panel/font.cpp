#include "font.hpp"

#include <array>
#include <cassert>

#include "font_grid.hpp"

namespace eyebridge::robios {
namespace {

// Written by bake_font: family, then style, then size; each face kGlyphCount cells.
constexpr std::size_t kFaces = 3 * kFontStyles * kFontGrids.size();
constexpr const char* kFaceBytes[] = {
#include "font_data.inc"
};
static_assert(std::size(kFaceBytes) == kFaces);

constexpr std::array<int, kFontGrids.size()> kSizes = [] {
  std::array<int, kFontGrids.size()> sizes{};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    sizes[i] = kFontGrids[i].size;
  }
  return sizes;
}();

std::size_t index_of(int size) {
  std::size_t index = 0;
  while (index + 1 < kSizes.size() && kSizes[index] != size) {
    ++index;
  }
  assert(kSizes[index] == size);
  return index;
}

}  // namespace

Font::Font(FontFamily family, FontStyle style, int size)
    : cell_width_(kFontGrids[index_of(size)].width),
      cell_height_(kFontGrids[index_of(size)].height),
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes kept as a literal
      glyphs_(reinterpret_cast<const std::uint8_t*>(
          kFaceBytes[(static_cast<std::size_t>(family) * kFontStyles +
                      static_cast<std::size_t>(style)) *
                         kFontGrids.size() +
                     index_of(size)])) {}

std::span<const std::uint8_t> Font::glyph(std::uint8_t code) const {
  const auto bytes = static_cast<std::size_t>(cell_width_ * cell_height_);
  return {glyphs_ + static_cast<std::size_t>(glyph_of_latin1(code)) * bytes, bytes};
}

std::span<const int> font_sizes() { return kSizes; }

}  // namespace eyebridge::robios
