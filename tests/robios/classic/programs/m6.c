/* A C program of the M6: names, camera handles, a camera buffer. */
#include "eyebot.h"
#include "tell.h"

colimage c;

int main() {
  CAMHandle cam;
  VWHandle vw;
  PSDHandle a, b;
  LCDInit();
  KEYInit();
  cam = CAMInit("NORMAL");
  vw = VWInit("VW_DRIVE", 1);
  printf("camera %d, drive %d\n", cam, vw);
  TELL("frame", CAMGetFrameRGB(cam, &c));
  TELL("shown", LCDPutImageRGB(0, 0, imagecolumns, imagerows, &c));
  LCDRefresh();
  VWDriveStraight(vw, 0.1, 0.2);
  VWDriveWait(vw);
  a = PSDInit("PSD_LEFT");
  b = PSDInit("PSD0");
  printf("sensors %d %d\n", a, b);
  TELL("unknown", PSDInit("NOTHING"));
  TELL("release", PSDRelease(a));
  TELL("released", PSDGet(a));
  TELL("other", PSDGet(b) > 0);
  TELL("all", PSDRelease());
  TELL("other", PSDGet(b));
  TELL("lists", LCDSetList(NULL));
  TELL("camera", CAMRelease(cam));
  TELL("again", CAMRelease(cam));
  LCDRelease();
  return 0;
}
