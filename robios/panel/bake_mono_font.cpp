// Build tool: draws the glyphs of one typeface, black and white, into cells of 8 x 8 pixels and writes
// them as a C++ literal: for each glyph eight rows from the top, the highest bit left.
//
//   bake_mono_font OUT FONT        (path of a TrueType file)

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "font_grid.hpp"

namespace {

using eyebridge::robios::kGlyphCount;
using eyebridge::robios::latin1_of_glyph;

constexpr int kCell = 8;
// Wider than high, so that letters of seven rows fill their cells; one row stays below the baseline,
// and what hangs deeper is cut off.
constexpr int kGlyphWidth = 11;
constexpr int kGlyphHeight = 9;
constexpr int kBaseline = 7;

void check(FT_Error error, const std::string& what) {
  if (error != 0) {
    throw std::runtime_error(what + ": FreeType error " + std::to_string(error));
  }
}

using Cell = std::array<std::uint8_t, kCell>;

/// The rows of a glyph from its top. Those of one that is too tall for its cell are made fewer where
/// two are the same: the dot of an i stays.
std::vector<std::uint8_t> rows_of(const FT_GlyphSlot slot) {
  const FT_Bitmap& bitmap = slot->bitmap;
  std::vector<std::uint8_t> rows(bitmap.rows, 0);
  for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
    for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
      const int x = slot->bitmap_left + column;
      const int byte = bitmap.buffer[row * bitmap.pitch + column / 8];
      if (x < 0 || x >= kCell || (byte & 0x80 >> column % 8) == 0) continue;
      rows.at(static_cast<std::size_t>(row)) |= static_cast<std::uint8_t>(0x80 >> x);
    }
  }
  for (int excess = slot->bitmap_top - kBaseline; excess > 0 && !rows.empty(); --excess) {
    const auto twin = std::adjacent_find(rows.begin(), rows.end());
    rows.erase(twin == rows.end() ? rows.begin() : twin);
  }
  return rows;
}

Cell drawn(FT_Face face, unsigned code) {
  check(FT_Load_Char(face, code, FT_LOAD_TARGET_MONO | FT_LOAD_RENDER), "glyph");
  const std::vector<std::uint8_t> rows = rows_of(face->glyph);
  int top = std::max(kBaseline - face->glyph->bitmap_top, 0);
  if (top >= kCell) top = kCell - static_cast<int>(rows.size());  // the underscore
  Cell cell{};
  for (std::size_t row = 0; row < rows.size() && top + static_cast<int>(row) < kCell; ++row) {
    cell.at(static_cast<std::size_t>(top) + row) = rows[row];
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
