// Build tool: draws the glyphs of six typefaces into cells and writes them as a C++ fragment.
//
//   bake_font OUT Sans Sans-Bold Serif Serif-Bold Mono Mono-Bold      (paths of TrueType files)
//
// Kept out of the library so that only building needs FreeType and the fonts.

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "font_grid.hpp"

namespace {

using eyebridge::robios::kFontGrids;
using eyebridge::robios::kFontStyles;
using eyebridge::robios::kGlyphCount;
using eyebridge::robios::latin1_of_glyph;

void check(FT_Error error, const std::string& what) {
  if (error != 0) {
    throw std::runtime_error(what + ": FreeType error " + std::to_string(error));
  }
}

class Face {
 public:
  Face(FT_Library library, const std::string& path) : path_(path) {
    check(FT_New_Face(library, path.c_str(), 0, &face_), path);
  }
  ~Face() { FT_Done_Face(face_); }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;

  /// Draws one character, centred in its cell; what is wider than the cell is squeezed.
  void draw(FT_Library library, unsigned code, bool slanted, int cell_width, int cell_height,
            std::vector<std::uint8_t>& out) const {
    // Light hinting: stems snap to rows only, so that squeezing sideways does not undo it.
    check(FT_Load_Char(face_, code, FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP), path_);
    FT_GlyphSlot slot = face_->glyph;
    FT_Outline* outline = &slot->outline;
    const FT_Pos cell = cell_width * 64;
    if (slot->advance.x > cell) {
      FT_Matrix squeeze{};
      squeeze.xx = FT_DivFix(cell, slot->advance.x);
      squeeze.yy = 0x10000;
      FT_Outline_Transform(outline, &squeeze);
    }
    const FT_Pos advance = slot->advance.x > cell ? cell : slot->advance.x;
    if (slanted) {
      FT_Matrix slant{};
      slant.xx = 0x10000;
      slant.yy = 0x10000;
      slant.xy = 0x10000 / 5;
      FT_Outline_Transform(outline, &slant);
    }
    const FT_Pos below = (-face_->size->metrics.descender + 63) / 64 * 64;
    FT_Outline_Translate(outline, (cell - advance) / 2, below);

    std::vector<std::uint8_t> cells(
        static_cast<std::size_t>(cell_width) * static_cast<std::size_t>(cell_height), 0);
    FT_Bitmap bitmap{};
    bitmap.width = static_cast<unsigned>(cell_width);
    bitmap.rows = static_cast<unsigned>(cell_height);
    bitmap.pitch = cell_width;
    bitmap.num_grays = 256;
    bitmap.pixel_mode = FT_PIXEL_MODE_GRAY;
    bitmap.buffer = cells.data();
    check(FT_Outline_Get_Bitmap(library, outline, &bitmap), path_);
    out.insert(out.end(), cells.begin(), cells.end());
  }

  void set_size(int pixels) const {
    check(FT_Set_Pixel_Sizes(face_, 0, static_cast<FT_UInt>(pixels)), path_);
  }

 private:
  std::string path_;
  FT_Face face_ = nullptr;
};

void write_literal(std::ofstream& out, const std::vector<std::uint8_t>& bytes) {
  std::string line;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i % 64 == 0) {
      out << line << (i == 0 ? "\"" : "\"\n\"");
      line.clear();
    }
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "\\%03o", static_cast<unsigned>(bytes[i]));
    line += text.data();
  }
  out << line << "\"";
}

void bake(const std::string& out_path, const std::array<std::string, 6>& fonts) {
  FT_Library library = nullptr;
  check(FT_Init_FreeType(&library), "FreeType");
  {
    std::ofstream out(out_path, std::ios::binary);
    for (std::size_t family = 0; family < 3; ++family) {
      const Face normal(library, fonts.at(family * 2));
      const Face bold(library, fonts.at(family * 2 + 1));
      for (int style = 0; style < kFontStyles; ++style) {
        const Face& face = style == 1 ? bold : normal;
        for (const auto& grid : kFontGrids) {
          face.set_size(grid.size);
          std::vector<std::uint8_t> bytes;
          for (int glyph = 0; glyph < kGlyphCount; ++glyph) {
            face.draw(library, latin1_of_glyph(glyph), style == 2, grid.width, grid.height, bytes);
          }
          write_literal(out, bytes);
          out << ",\n";
        }
      }
    }
    if (!out.flush()) {
      throw std::runtime_error(out_path + ": cannot be written");
    }
  }
  FT_Done_FreeType(library);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 8) {
    std::fputs("usage: bake_font OUT SANS SANS_BOLD SERIF SERIF_BOLD MONO MONO_BOLD\n", stderr);
    return 2;
  }
  try {
    bake(argv[1], {argv[2], argv[3], argv[4], argv[5], argv[6], argv[7]});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bake_font: %s\n", error.what());
    return 1;
  }
  return 0;
}
