#include "code/templates.hpp"

namespace eyebridge::gui {
namespace {

constexpr const char* kC = R"(#include "eyebot.h"

int main() {
  LCDMenu("", "", "", "END");
  /* Until there is a wall ahead, or key 4 is pressed. */
  while (PSDGet(PSD_FRONT) > 200 && KEYRead() != KEY4) {
    VWSetSpeed(150, 0); /* mm/s, degrees/s */
    LCDPrintf("front %4d mm\n", PSDGet(PSD_FRONT));
    OSWait(100);
  }
  VWSetSpeed(0, 0);
  printf("wall at %d mm\n", PSDGet(PSD_FRONT));
  return 0;
}
)";

constexpr const char* kCpp = R"(#include <iostream>

#include "eyebot++.h"

int main() {
  LCDMenu("", "", "", "END");
  for (int side = 0; side < 4 && KEYRead() != KEY4; ++side) {
    VWStraight(300, 150);  // mm, mm/s
    VWWait();
    VWTurn(90, 90);  // degrees, degrees/s
    VWWait();
  }
  int x = 0, y = 0, phi = 0;
  VWGetPosition(&x, &y, &phi);
  std::cout << "back at " << x << ' ' << y << " mm\n";
}
)";

constexpr const char* kPython = R"(from eye import *

LCDMenu("", "", "", "END")
# Until there is a wall ahead, or key 4 is pressed.
while PSDGet(PSD_FRONT) > 200 and KEYRead() != KEY4:
    VWSetSpeed(150, 0)  # mm/s, degrees/s
    LCDPrintf("front %4d mm\n", PSDGet(PSD_FRONT))
    OSWait(100)
VWSetSpeed(0, 0)
print("wall at", PSDGet(PSD_FRONT), "mm")
)";

}  // namespace

const std::vector<Template>& templates() {
  static const std::vector<Template> all{{Language::C, "program.c", kC},
                                         {Language::Cpp, "program.cpp", kCpp},
                                         {Language::Python, "program.py", kPython}};
  return all;
}

}  // namespace eyebridge::gui
