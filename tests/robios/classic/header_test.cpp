#include <type_traits>

#include <gtest/gtest.h>

#include <eyebot.h>

extern "C" {
int classic_names_in_use(void);
int classic_sizes(void);
}

namespace {

TEST(ClassicHeader, LeavesProgramsTheirNames) {
  EXPECT_EQ(classic_names_in_use(), 20);
  EXPECT_EQ(classic_sizes(), 1);
}

TEST(ClassicHeader, HasTheKnownNumbers) {
  EXPECT_EQ(PSD_LEFT, -205);
  EXPECT_EQ(PSD_FRONT, -200);
  EXPECT_EQ(PSD_RIGHT, -210);
  EXPECT_EQ(BUMP_RIGHT, -500);
  EXPECT_EQ(VW, VW_DRIVE);
  EXPECT_EQ(PSD_OUT_OF_RANGE, 9999);
  EXPECT_EQ(KEY1 + KEY2 + KEY3 + KEY4, 15);
  EXPECT_EQ(NOTASK, 255);
  EXPECT_EQ(DEFAULT, COOP);
  EXPECT_EQ(FPS0_46875 - FPS60, 7);
  EXPECT_GT(NOCAM, INITERROR);
}

TEST(ClassicHeader, HasTheSignaturesOfTheManuals) {
  EXPECT_TRUE((std::is_same_v<decltype(&VWDriveCurve), int (*)(int, float, float, float)>));
  EXPECT_TRUE((std::is_same_v<decltype(&CAMGetColFrame), int (*)(colimage*, int)>));
  EXPECT_TRUE((std::is_same_v<decltype(&BUMPCheck), int (*)(int, int*)>));
  EXPECT_TRUE((std::is_same_v<decltype(&OSMachineID), unsigned char (*)()>));
  EXPECT_TRUE((std::is_same_v<decltype(&OSWriteOutLatch), BYTE (*)(int, BYTE, BYTE)>));
}

}  // namespace
