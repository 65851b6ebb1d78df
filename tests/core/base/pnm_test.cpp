#include "eyebridge/base/pnm.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge {
namespace {

using Image = std::vector<std::uint8_t>;

PnmPicture read(std::string_view text) { return read_pnm(text, "test.pnm"); }

std::string error_of(std::string_view text) {
  try {
    read(text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ReadPnm, ReadsTextBitmapsWithAndWithoutBlanks) {
  const PnmPicture expected{PnmKind::Bitmap, 3, 2, {1, 0, 1, 0, 1, 0}};
  EXPECT_EQ(read("P1 3 2\n1 0 1\n0 1 0\n"), expected);
  EXPECT_EQ(read("P1\n3 2\n101010"), expected);
}

TEST(ReadPnm, ReadsTextGreyAndScalesIt) {
  EXPECT_EQ(read("P2 3 1 10 0 5 10"),
            (PnmPicture{PnmKind::Grey, 3, 1, {0, 128, 255}}));  // 127.5 rounds up
}

TEST(ReadPnm, ReadsTextColour) {
  EXPECT_EQ(read("P3 1 2 255 1 2 3 4 5 6"),
            (PnmPicture{PnmKind::Colour, 1, 2, {1, 2, 3, 4, 5, 6}}));
}

TEST(ReadPnm, ReadsBinaryBitmapsWithPaddedRows) {
  const PnmPicture image = read("P4\n9 2\n\x80\x80\x01\x7F");
  EXPECT_EQ(image.columns, 9);
  EXPECT_EQ(image.rows, 2);
  EXPECT_EQ(image.bytes, (Image{1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0}));
}

TEST(ReadPnm, ReadsBinaryGreyAndColour) {
  EXPECT_EQ(read(std::string_view("P5 2 1 255\n\x00\xFF", 13)).bytes, (Image{0, 255}));
  EXPECT_EQ(read("P6 1 1 255\nabc").bytes, (Image{'a', 'b', 'c'}));
}

TEST(ReadPnm, ReadsSixteenBitValues) {
  EXPECT_EQ(read(std::string_view("P5 2 1 65535\n\x80\x00\xFF\xFF", 17)).bytes, (Image{128, 255}));
}

TEST(ReadPnm, SkipsComments) {
  EXPECT_EQ(read("P2 # made by hand\n# 7 7\n2 1\n#x\n255 # max\n3 #\n 4").bytes, (Image{3, 4}));
}

TEST(ReadPnm, ABinaryPixelMayLookLikeABlankOrAComment) {
  EXPECT_EQ(read("P5 2 1 255\n #").bytes, (Image{' ', '#'}));
}

TEST(ReadPnm, ABinaryValueBeyondTheLargestCountsAsThat) {
  EXPECT_EQ(read("P5 2 1 10\n\x05\x0B").bytes, (Image{128, 255}));
}

TEST(ReadPnm, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(error_of(""),
            "test.pnm:1:1: no PNM picture: expected a file that begins with P1 to P6");
  EXPECT_EQ(error_of("P7 1 1"),
            "test.pnm:1:1: no PNM picture: expected a file that begins with P1 to P6");
  EXPECT_EQ(error_of("P2\nx"), "test.pnm:2:1: no number: expected the width");
  EXPECT_EQ(error_of("P2\n2 1 9 1\n12"), "test.pnm:3:1: a value is 12: expected 0 to 9");
  EXPECT_EQ(error_of("P5 1 1 65536\n"),
            "test.pnm:1:8: the largest value is 65536: expected 1 to 65535");
  EXPECT_EQ(error_of("P5 1 1 255\n"),
            "test.pnm:2:1: file has 0 bytes of pixels: expected 1, 1 x 1");
  EXPECT_EQ(error_of("P1 2 1\n1 3"), "test.pnm:2:3: expected 0 or 1");
}

TEST(ReadPnm, TakesNoMorePixelsThanAreAllowed) {
  EXPECT_EQ(read_pnm("P1 2 2 1 1 1 1", "", 4).bytes.size(), 4U);
  EXPECT_THROW(read_pnm("P1 2 2 1 1 1 1", "", 3), ConfigError);
}

TEST(ReadPnm, RefusesHostileFiles) {
  for (const std::string_view text :
       {"P", "P1", "P2 0 5 255 ", "P2 -1 5 255 ", "P2 99999999999999999999 1 255 1",
        "P5 16777216 16777216 255\nx", "P6 65535 65535 65535\n", "P4 65535 65535\n",
        "P1 65535 65535 1", "P2 1 1 0 0", "P2 1 1 65536 0", "P2 2 1 255 1", "P1 1 1 2",
        "P3 1 1 255 1 2", "P5 1 1", "P5 1 1 255", "P5 1 1 255#x\n1", "P2 1 1 255 #no end"}) {
    EXPECT_THROW(read(text), ConfigError) << text;
  }
}

TEST(ReadPnm, EveryCutOfAFileIsRefused) {
  const std::string_view whole = "P6 3 2 255\nabcdefghijklmnopqr";
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_THROW(read(whole.substr(0, length)), ConfigError) << length;
  }
  EXPECT_EQ(read(whole).bytes.size(), 18U);
}

}  // namespace
}  // namespace eyebridge
