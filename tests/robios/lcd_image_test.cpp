#include <climits>

#include <gtest/gtest.h>

#include "lcd.hpp"
#include "lcd_test_support.hpp"

namespace eyebridge::robios {
namespace {

TEST(LcdImage, ColourGreyAndBinaryPixelsMeanWhatTheManualSays) {
  Lcd lcd;
  ASSERT_TRUE(lcd.set_image_window({10, 20, 2, 1}));
  const std::array<std::uint8_t, 6> colour{1, 2, 3, 4, 5, 6};
  lcd.image(colour.data());
  EXPECT_EQ(lcd.pixel_at(10, 20).value(), (Rgb{1, 2, 3}));
  EXPECT_EQ(lcd.pixel_at(11, 20).value(), (Rgb{4, 5, 6}));
  const std::array<std::uint8_t, 2> grey{0, 200};
  lcd.image_grey(grey.data());
  EXPECT_EQ(lcd.pixel_at(10, 20).value(), kBlack);
  EXPECT_EQ(lcd.pixel_at(11, 20).value(), (Rgb{200, 200, 200}));
  const std::array<std::uint8_t, 2> binary{0, 1};
  lcd.image_binary(binary.data());
  EXPECT_EQ(lcd.pixel_at(10, 20).value(), kWhite);
  EXPECT_EQ(lcd.pixel_at(11, 20).value(), kBlack);
  EXPECT_EQ(lcd.pixel_at(12, 20).value(), kBlack);
  EXPECT_EQ(lcd.pixel_at(10, 21).value(), kBlack);
}

TEST(LcdImage, IsQvgaAtTheStartAndThenTheCameras) {
  Lcd lcd;
  EXPECT_EQ(lcd.image_window(), (ImageWindow{0, 0, 320, 240}));
  lcd.follow_camera(160, 120);
  EXPECT_EQ(lcd.image_window(), (ImageWindow{0, 0, 160, 120}));
}

TEST(LcdImage, StaysWhereAProgramPlacedIt) {
  Lcd lcd;
  ASSERT_TRUE(lcd.set_image_window({5, 6, 128, 128}));
  lcd.follow_camera(640, 480);
  EXPECT_EQ(lcd.image_window(), (ImageWindow{5, 6, 128, 128}));
  ASSERT_TRUE(lcd.set_image_mode(0));
  EXPECT_EQ(lcd.image_window(), (ImageWindow{0, 0, 160, 120}));
  lcd.follow_camera(640, 480);
  EXPECT_EQ(lcd.image_window(), (ImageWindow{0, 0, 640, 480}));
}

TEST(LcdImage, RefusesModesAndSizesThatThereAreNot) {
  Lcd lcd;
  for (const int mode : {INT_MIN, -1, 6, 10, INT_MAX}) {
    EXPECT_FALSE(lcd.set_image_mode(mode)) << mode;
  }
  EXPECT_FALSE(lcd.set_image_window({0, 0, 0, 5}));
  EXPECT_FALSE(lcd.set_image_window({0, 0, 5, INT_MIN}));
  EXPECT_FALSE(lcd.set_image_window({0, 0, 5, 4097}));
  EXPECT_EQ(lcd.image_window(), (ImageWindow{0, 0, 320, 240}));
}

TEST(LcdImage, ReadsNothingOfAPictureThatIsOutside) {
  Lcd lcd;
  const std::uint8_t nothing = 0;
  ASSERT_TRUE(lcd.set_image_window({INT_MAX, INT_MAX, 4096, 4096}));
  lcd.image(&nothing);
  ASSERT_TRUE(lcd.set_image_window({INT_MIN, INT_MIN, 4096, 4096}));
  lcd.image(&nothing);
  EXPECT_EQ(lcd.snapshot().bytes, Lcd().snapshot().bytes);
}

TEST(LcdDraw, PixelsOutsideTheScreenAreErrorsToReadAndNothingToDraw) {
  Lcd lcd;
  lcd.pixel(INT_MIN, 0, kRed);
  lcd.pixel(0, 400, kRed);
  EXPECT_EQ(lcd.snapshot().bytes, Lcd().snapshot().bytes);
  EXPECT_EQ(lcd.pixel_at(560, 0).error().what, "no pixel 560, 0");
  EXPECT_FALSE(lcd.pixel_at(0, -1));
  lcd.pixel(559, 399, kRed);
  EXPECT_EQ(lcd.pixel_at(559, 399).value(), kRed);
}

TEST(LcdDraw, RefusesCirclesOfNegativeSize) {
  Lcd lcd;
  EXPECT_EQ(lcd.circle(0, 0, -1, kRed, true).error().what, "radius -1, expected at least 0");
  EXPECT_TRUE(lcd.circle(0, 0, 0, kRed, true));
  EXPECT_EQ(lcd.pixel_at(0, 0).value(), kRed);
}

TEST(LcdRefresh, ShowsWhatWasDrawnMeanwhile) {
  Lcd lcd;
  lcd.pixel(1, 1, kGreen);
  lcd.set_mode(0x0100);
  const auto before = lcd.revision();
  lcd.pixel(1, 1, kRed);
  EXPECT_EQ(lcd.pixel_at(1, 1).value(), kGreen);
  EXPECT_EQ(lcd.revision(), before);
  lcd.refresh();
  EXPECT_EQ(lcd.pixel_at(1, 1).value(), kRed);
  EXPECT_GT(lcd.revision(), before);
  lcd.pixel(2, 2, kRed);
  lcd.set_mode(0x0001);
  EXPECT_EQ(lcd.pixel_at(2, 2).value(), kRed);
}

}  // namespace
}  // namespace eyebridge::robios
