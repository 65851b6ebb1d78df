#include <map>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "font.hpp"
#include "utf8.hpp"

namespace eyebridge::robios {
namespace {

constexpr FontFamily kFamilies[] = {FontFamily::Helvetica, FontFamily::Times, FontFamily::Courier};
constexpr FontStyle kStyles[] = {FontStyle::Normal, FontStyle::Bold, FontStyle::Italics};

int ink(const Font& font, std::uint8_t code) {
  const auto glyph = font.glyph(code);
  return std::accumulate(glyph.begin(), glyph.end(), 0);
}

int ink_of_alphabet(const Font& font) {
  int sum = 0;
  for (std::uint8_t code = 'a'; code <= 'z'; ++code) {
    sum += ink(font, code);
  }
  return sum;
}

TEST(Font, EveryVisibleCharacterHasInkInEveryTypeface) {
  for (const FontFamily family : kFamilies) {
    for (const FontStyle style : kStyles) {
      for (const int size : font_sizes()) {
        const Font font(family, style, size);
        for (int code = 33; code < 256; ++code) {
          if (code != 160 && code != 173) {  // the two that are blank or may be
            EXPECT_GT(ink(font, static_cast<std::uint8_t>(code)), 0) << size << ' ' << code;
          }
        }
        EXPECT_EQ(ink(font, ' '), 0);
      }
    }
  }
}

TEST(Font, LettersDifferFromEachOther) {
  for (const FontFamily family : kFamilies) {
    const Font font(family, FontStyle::Normal, 12);
    std::map<std::vector<std::uint8_t>, int> seen;
    for (int code = 32; code < 127; ++code) {
      const auto glyph = font.glyph(static_cast<std::uint8_t>(code));
      const auto [at, is_new] = seen.try_emplace({glyph.begin(), glyph.end()}, code);
      EXPECT_TRUE(is_new) << code << " looks like " << at->second;
    }
  }
}

TEST(Font, BoldHasMoreInkThanNormal) {
  for (const FontFamily family : kFamilies) {
    for (const int size : font_sizes()) {
      EXPECT_GT(ink_of_alphabet(Font(family, FontStyle::Bold, size)),
                ink_of_alphabet(Font(family, FontStyle::Normal, size)))
          << size;
    }
  }
}

TEST(Font, FamiliesAndStylesLookDifferent) {
  std::map<std::vector<std::uint8_t>, int> seen;
  int face = 0;
  for (const FontFamily family : kFamilies) {
    for (const FontStyle style : kStyles) {
      const auto glyph = Font(family, style, 18).glyph('R');
      EXPECT_TRUE(seen.try_emplace({glyph.begin(), glyph.end()}, face++).second);
    }
  }
}

TEST(Font, CellsGrowWithTheSize) {
  int width = 0;
  int height = 0;
  for (const int size : font_sizes()) {
    const Font font(FontFamily::Courier, FontStyle::Normal, size);
    EXPECT_GT(font.cell_width(), width);
    EXPECT_GT(font.cell_height(), height);
    EXPECT_GE(font.cell_height(), size);
    width = font.cell_width();
    height = font.cell_height();
    EXPECT_EQ(font.glyph('A').size(), static_cast<std::size_t>(width * height));
  }
}

TEST(Font, ControlCodesLookLikeAQuestionMark) {
  const Font font(FontFamily::Helvetica, FontStyle::Normal, 12);
  for (const int code : {0, 7, 31, 127, 128, 159}) {
    EXPECT_EQ(font.glyph(static_cast<std::uint8_t>(code)).data(), font.glyph('?').data());
  }
}

TEST(Latin1, IsTakenFromUtf8OrFromBytesThatAreNot) {
  EXPECT_EQ(to_latin1("30\xC2\xB0"), "30\xB0");
  EXPECT_EQ(to_latin1("30\xB0"), "30\xB0");
  EXPECT_EQ(to_latin1("\xE2\x82\xAC 5"), "? 5");  // the euro sign is beyond Latin-1
  EXPECT_EQ(to_latin1("\xF0\x9F\xA4\x96"), "?");  // a robot face
  EXPECT_EQ(to_latin1("\xC3"), "\xC3");           // cut short
  EXPECT_EQ(to_latin1("\xC0\x80"), "\xC0\x80");   // overlong: not UTF-8
  EXPECT_EQ(to_utf8("30\xB0"), "30\xC2\xB0");
}

}  // namespace
}  // namespace eyebridge::robios
