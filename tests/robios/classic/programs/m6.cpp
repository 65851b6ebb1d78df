// The same generation in C++: overloads take names.
#include <cstdio>

#include "eyebot.h"
#include "tell.h"
using std::printf;

int main() {
  const char* const name = "PSD_FRONT";
  const PSDHandle psd = PSDInit(name);
  const CAMHandle camera = CAMInit("NORMAL");
  colimage picture;
  TELL("psd", psd);
  TELL("range", PSDGet(psd) > 0);
  TELL("camera", camera);
  TELL("frame", CAMGetFrameRGB(camera, &picture));
  TELL("release", CAMRelease(camera));
  TELL("drive", VWInit("VW_DRIVE", 1));
  TELL("by number", VWInit(VW, 1));
  TELL("taken", MOTORInit("MOTOR_LEFT"));
  TELL("none", PSDInit(UNKNOWN_SEMANTICS));
  TELL("release", PSDRelease(psd));
  TELL("camera by number", CAMInit(NORMAL));
}
