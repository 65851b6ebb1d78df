#include <climits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lcd.hpp"
#include "lcd_test_support.hpp"

namespace eyebridge::robios {
namespace {

constexpr int kTop = Lcd::kDefaultHeight - kMenuHeight;
constexpr int kKeyWidth = Lcd::kDefaultWidth / kSoftKeys;

/// A pixel just inside the frame of a key, where no text is.
Rgb paper_of(const Lcd& lcd, int key) {
  return lcd.pixel_at(key * kKeyWidth + 1, kTop + 1).value();
}

TEST(LcdMenu, HasRedGreenYellowAndBlueKeysWithABlackFrame) {
  Lcd lcd;
  lcd.set_menu({"", "", "", ""});
  EXPECT_EQ(paper_of(lcd, 0), kRed);
  EXPECT_EQ(paper_of(lcd, 1), kGreen);
  EXPECT_EQ(paper_of(lcd, 2), (Rgb{255, 255, 0}));
  EXPECT_EQ(paper_of(lcd, 3), (Rgb{0, 0, 255}));
  EXPECT_EQ(lcd.pixel_at(0, kTop).value(), kBlack);
  EXPECT_EQ(lcd.pixel_at(kKeyWidth - 1, kTop + 5).value(), kBlack);
  EXPECT_EQ(lcd.pixel_at(50, Lcd::kDefaultHeight - 1).value(), kBlack);
}

TEST(LcdMenu, IsNotThereUntilAProgramAsksForIt) {
  const Lcd lcd;
  EXPECT_EQ(paper_of(lcd, 0), kBlack);
  EXPECT_EQ(lcd.key_at(10, Lcd::kDefaultHeight - 10), 0);
}

TEST(LcdMenu, LabelsAreCentred) {
  Lcd lcd;
  lcd.set_menu({"GO", "", "", ""});
  int left = kKeyWidth;
  int right = 0;
  for (int y = kTop + 1; y < Lcd::kDefaultHeight - 1; ++y) {
    for (int x = 1; x < kKeyWidth - 1; ++x) {
      if (lcd.pixel_at(x, y).value() != kRed) {
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
  }
  ASSERT_LT(left, right);
  EXPECT_NEAR((left + right) / 2.0, (kKeyWidth - 1) / 2.0, 2.0);
  EXPECT_LE(right - left, 14);  // two cells of seven pixels
}

TEST(LcdMenu, LabelsMayHaveLinesAndBeTooLong) {
  Lcd one;
  one.set_menu({"A", "", "", ""});
  Lcd two;
  two.set_menu({"A\nA", "", "", ""});
  EXPECT_NE(one.snapshot().bytes, two.snapshot().bytes);
  const std::string endless(500, 'W');
  two.set_menu({endless, endless, endless, "\n\n\n\n\n\n"});
  EXPECT_EQ(two.menu_labels()[0].size(), 31u);
  EXPECT_EQ(paper_of(two, 1), kGreen);  // nothing spills into the next key's frame
  EXPECT_EQ(two.pixel_at(kKeyWidth, kTop + 19).value(), kBlack);
}

TEST(LcdMenu, OneLabelHasItsOwnColours) {
  Lcd lcd;
  ASSERT_TRUE(lcd.set_menu_label(2, "X", kWhite, kRed));
  EXPECT_EQ(paper_of(lcd, 1), kRed);
  EXPECT_EQ(paper_of(lcd, 0), kRed);
  EXPECT_EQ(paper_of(lcd, 2), (Rgb{255, 255, 0}));
  EXPECT_EQ(lcd.menu_labels()[1], "X");
}

TEST(LcdMenu, PositionsCountFromOneUntilAProgramUsesZero) {
  Lcd manual;
  ASSERT_TRUE(manual.set_menu_label(1, "a", kBlack, kRed));
  ASSERT_TRUE(manual.set_menu_label(4, "d", kBlack, kRed));
  EXPECT_THAT(manual.menu_labels(), testing::ElementsAre("a", "", "", "d"));

  Lcd zero;
  ASSERT_TRUE(zero.set_menu_label(0, "a", kBlack, kRed));
  ASSERT_TRUE(zero.set_menu_label(1, "b", kBlack, kRed));
  ASSERT_TRUE(zero.set_menu_label(3, "d", kBlack, kRed));
  EXPECT_THAT(zero.menu_labels(), testing::ElementsAre("a", "b", "", "d"));
  EXPECT_EQ(zero.set_menu_label(4, "x", kBlack, kRed).error().what,
            "menu position 4, expected 0..3");
  zero.set_menu({"", "", "", ""});
  ASSERT_TRUE(zero.set_menu_label(4, "d", kBlack, kRed));
  EXPECT_EQ(zero.menu_labels()[3], "d");
}

TEST(LcdMenu, RefusesOtherPositions) {
  Lcd lcd;
  for (const int position : {INT_MIN, -1, 5, INT_MAX}) {
    EXPECT_EQ(lcd.set_menu_label(position, "", kBlack, kRed).error().code, Errc::OutOfRange);
  }
  EXPECT_EQ(lcd.set_menu_label(5, "", kBlack, kRed).error().what, "menu position 5, expected 1..4");
}

TEST(LcdMenu, KnowsTheKeyUnderAFinger) {
  Lcd lcd;
  lcd.set_menu({"a", "b", "c", "d"});
  EXPECT_EQ(lcd.key_at(0, kTop), 1);
  EXPECT_EQ(lcd.key_at(kKeyWidth - 1, kTop), 1);
  EXPECT_EQ(lcd.key_at(kKeyWidth, kTop), 2);
  EXPECT_EQ(lcd.key_at(2 * kKeyWidth, kTop + 37), 4);
  EXPECT_EQ(lcd.key_at(Lcd::kDefaultWidth - 1, kTop), 8);
  EXPECT_EQ(lcd.key_at(0, kTop - 1), 0);
  EXPECT_EQ(lcd.key_at(0, Lcd::kDefaultHeight), 0);
  EXPECT_EQ(lcd.key_at(-1, kTop), 0);
  EXPECT_EQ(lcd.key_at(Lcd::kDefaultWidth, kTop), 0);
}

TEST(LcdMenu, CoversAndUncoversWhatIsDrawnBelow) {
  Lcd lcd;
  lcd.area(0, 0, Lcd::kDefaultWidth, Lcd::kDefaultHeight, kWhite, true);
  lcd.set_menu({"", "", "", ""});
  EXPECT_EQ(paper_of(lcd, 0), kRed);
  lcd.set_mode(0x0800);
  EXPECT_EQ(paper_of(lcd, 0), kWhite);
  EXPECT_EQ(lcd.key_at(5, kTop + 5), 0);
  lcd.set_mode(0x0008);
  EXPECT_EQ(paper_of(lcd, 0), kRed);
}

TEST(LcdMenu, StaysWhenTheScreenIsCleared) {
  Lcd lcd;
  lcd.set_menu({"a", "b", "c", "d"});
  lcd.clear();
  EXPECT_EQ(paper_of(lcd, 0), kRed);
}

TEST(LcdMenu, SnapshotShowsWhatPixelsSay) {
  Lcd lcd;
  lcd.print("text");
  lcd.set_menu({"a", "b", "c", "d"});
  const camera::Frame frame = lcd.snapshot();
  ASSERT_EQ(frame.bytes.size(), 560u * 400u * 3u);
  for (int y = 0; y < frame.height; y += 3) {
    const auto row = frame.row(y);
    for (int x = 0; x < frame.width; x += 7) {
      const auto i = static_cast<std::size_t>(3 * x);
      ASSERT_EQ((Rgb{row[i], row[i + 1], row[i + 2]}), lcd.pixel_at(x, y).value());
    }
  }
}

}  // namespace
}  // namespace eyebridge::robios
