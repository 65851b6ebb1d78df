// The same generation in C++: overloads take names.
#include <cstdio>

#include "eyebot.h"

int main() {
  const char* const name = "PSD_FRONT";
  const PSDHandle psd = PSDInit(name);
  const CAMHandle camera = CAMInit("NORMAL");
  colimage picture;
  std::printf("psd %d range %d\n", psd, PSDGet(psd) > 0);
  std::printf("camera %d %d %d\n", camera, CAMGetFrameRGB(camera, &picture), CAMRelease(camera));
  std::printf("drive %d by number %d\n", VWInit("VW_DRIVE", 1), VWInit(VW, 1));
  std::printf("none %d %d\n", MOTORInit("MOTOR_LEFT"), PSDInit(UNKNOWN_SEMANTICS));
  std::printf("released %d, camera by number %d\n", PSDRelease(psd), CAMInit(NORMAL));
}
