#include <type_traits>

#include <eyebridge.h>
#include <gtest/gtest.h>

#include <eyebot.h>

namespace {

TEST(HeaderValues, ImageModesAreThoseOfRoBios7) {
  EXPECT_EQ(QQVGA, 0);
  EXPECT_EQ(QVGA, 1);
  EXPECT_EQ(VGA, 2);
  EXPECT_EQ(CAM1MP, 3);
  EXPECT_EQ(CAMHD, 4);
  EXPECT_EQ(CAM5MP, 5);
  EXPECT_EQ(CUSTOM, 10);
  EXPECT_EQ(QQVGA_SIZE, 57600);
  EXPECT_EQ(QVGA_SIZE, 230400);
  EXPECT_EQ(VGA_SIZE, 921600);
  EXPECT_EQ(CAM1MP_SIZE, 2838240);
  EXPECT_EQ(CAMHD_SIZE, 6220800);
  EXPECT_EQ(CAM5MP_SIZE, 15116544);
  EXPECT_EQ(sizeof(QVGAcol), 230400u);
  EXPECT_EQ(sizeof(CAM5MPgray), 5038848u);
}

TEST(HeaderValues, KeysAreBitsOfAMask) {
  EXPECT_EQ(NOKEY, 0);
  EXPECT_EQ(KEY1, 1);
  EXPECT_EQ(KEY2, 2);
  EXPECT_EQ(KEY3, 4);
  EXPECT_EQ(KEY4, 8);
  EXPECT_EQ(static_cast<int>(ANYKEY), -1);
}

TEST(HeaderValues, ColoursAreTheReferenceOnes) {
  EXPECT_EQ(CYAN, 0x00EEEE);
  EXPECT_EQ(OLIVE, 0x9ACD32);
  EXPECT_EQ(ORANGE, 0xFFA500);
  EXPECT_EQ(LIGHTGRAY, 0xD3D3D3);
  EXPECT_EQ(DARKGRAY, 0xA9A9A9);
  EXPECT_EQ(SILVER, 0xC0C0C0);
}

TEST(HeaderValues, EverySwitchOfTheScreenHasItsOppositeEightBitsUp) {
  EXPECT_EQ(LCD_NOAUTOREFRESH, LCD_AUTOREFRESH << 8);
  EXPECT_EQ(LCD_NOSCROLLING, LCD_SCROLLING << 8);
  EXPECT_EQ(LCD_NOLINEFEED, LCD_LINEFEED << 8);
  EXPECT_EQ(LCD_HIDEMENU, LCD_SHOWMENU << 8);
  EXPECT_EQ(LCD_CLASSICMENU, LCD_LISTMENU << 8);
  EXPECT_EQ(LCD_FB_NOROTATION, LCD_FB_ROTATE << 8);
}

TEST(HeaderValues, SensorsHaveTheCurrentNumbers) {
  EXPECT_EQ(PSD_FRONT, 1);
  EXPECT_EQ(PSD_LEFT, 2);
  EXPECT_EQ(PSD_RIGHT, 3);
  EXPECT_EQ(PSD_BACK, 4);
}

TEST(HeaderValues, KeysOfTheRemoteControlAreCharacters) {
  EXPECT_EQ(IRTV_0, '0');
  EXPECT_EQ(IRTV_9, '9');
  EXPECT_EQ(IRTV_RED, 'R');
  EXPECT_EQ(IRTV_RIGHT, '>');
}

TEST(HeaderValues, FunctionsHaveTheSignaturesThatProgramsUse) {
  EXPECT_TRUE((std::is_same_v<decltype(&VWGetPosition), int (*)(int*, int*, int*)>));
  EXPECT_TRUE((std::is_same_v<decltype(&VWCurve), int (*)(int, int, int)>));
  EXPECT_TRUE((std::is_same_v<decltype(&LIDARGet), int (*)(int*)>));
  EXPECT_TRUE((std::is_same_v<decltype(&OSAttachTimer), TIMER (*)(int, void (*)(void))>));
  EXPECT_TRUE((std::is_same_v<decltype(&LCDSetPrintf), int (*)(int, int, const char*, ...)>));
  EXPECT_TRUE((std::is_same_v<decltype(&SIMSetRobot), int (*)(int, int, int, int, int)>));
  EXPECT_TRUE((std::is_same_v<decltype(&DIGITALSetup), int (*)(int, char)>));
  EXPECT_TRUE((std::is_same_v<decltype(&ANALOGTransfer), int (*)(BYTE*)>));
  EXPECT_TRUE((std::is_same_v<decltype(&SERReceiveChar), char (*)(int)>));
  EXPECT_TRUE((std::is_same_v<decltype(&SERReceive), int (*)(int, char*, int)>));
  EXPECT_TRUE((std::is_same_v<decltype(&RADIOReceive), int (*)(int*, char*, int)>));
  EXPECT_TRUE((std::is_same_v<decltype(&RADIOStatus), int (*)(int*)>));
  EXPECT_TRUE((std::is_same_v<decltype(&EYEBRIDGELastError), const char* (*)(void)>));
  EXPECT_TRUE((std::is_same_v<decltype(&EYEBRIDGEGyroscopeGet), int (*)(int*)>));
  EXPECT_TRUE((std::is_same_v<decltype(&EYEBRIDGERangeMatrixGet), int (*)(int, int*)>));
  EXPECT_TRUE((std::is_same_v<decltype(&EYEBRIDGEAccelerometerGet), int (*)(int*, int*)>));
}

}  // namespace
