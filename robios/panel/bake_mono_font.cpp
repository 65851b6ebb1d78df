// Build tool: draws the glyphs of one typeface, black and white, into cells of 8 x 8 pixels and writes
// them as a C++ literal: for each glyph eight rows from the top, the highest bit left.
//
//   bake_mono_font OUT FONT        (path of a TrueType file)

#include <ft2build.h>
#include FT_FREETYPE_H

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "font_grid.hpp"

namespace {

using eyebridge::robios::kGlyphCount;
using eyebridge::robios::latin1_of_glyph;

constexpr int kCell = 8;
// Wider than high, so that letters of six rows fill their cells; two rows stay below the baseline.
constexpr int kGlyphWidth = 12;
constexpr int kGlyphHeight = 8;
constexpr int kBaseline = 6;

void check(FT_Error error, const std::string& what) {
  if (error != 0) {
    throw std::runtime_error(what + ": FreeType error " + std::to_string(error));
  }
}

using Cell = std::array<std::uint8_t, kCell>;

Cell drawn(FT_Face face, unsigned code) {
  check(FT_Load_Char(face, code, FT_LOAD_TARGET_MONO | FT_LOAD_RENDER), "glyph");
  const FT_GlyphSlot slot = face->glyph;
  const FT_Bitmap& bitmap = slot->bitmap;
  Cell cell{};
  for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
    const int y = kBaseline - slot->bitmap_top + row;
    for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
      const int x = slot->bitmap_left + column;
      const int byte = bitmap.buffer[row * bitmap.pitch + column / 8];
      if (x < 0 || x >= kCell || y < 0 || y >= kCell || (byte & 0x80 >> column % 8) == 0) continue;
      cell.at(static_cast<std::size_t>(y)) |= static_cast<std::uint8_t>(0x80 >> x);
    }
  }
  return cell;
}

void bake(const std::string& out_path, const std::string& font) {
  FT_Library library = nullptr;
  check(FT_Init_FreeType(&library), "FreeType");
  FT_Face face = nullptr;
  check(FT_New_Face(library, font.c_str(), 0, &face), font);
  check(FT_Set_Pixel_Sizes(face, kGlyphWidth, kGlyphHeight), font);
  std::ofstream out(out_path, std::ios::binary);
  for (int glyph = 0; glyph < kGlyphCount; ++glyph) {
    out << '"';
    for (const std::uint8_t row : drawn(face, latin1_of_glyph(glyph))) {
      std::array<char, 8> text{};
      std::snprintf(text.data(), text.size(), "\\%03o", static_cast<unsigned>(row));
      out << text.data();
    }
    out << "\"\n";
  }
  FT_Done_Face(face);
  FT_Done_FreeType(library);
  if (!out.flush()) throw std::runtime_error(out_path + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: bake_mono_font OUT FONT\n", stderr);
    return 2;
  }
  try {
    bake(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bake_mono_font: %s\n", error.what());
    return 1;
  }
  return 0;
}
