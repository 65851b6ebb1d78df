/* A C program of the M6: names, camera handles, a camera buffer. */
#include "eyebot.h"

colimage c;

int main()
{ CAMHandle cam;
  VWHandle vw;
  PSDHandle a, b;
  LCDInit();
  KEYInit();
  cam = CAMInit("NORMAL");
  vw = VWInit("VW_DRIVE", 1);
  printf("camera %d, drive %d, frame %d\n", cam, vw, CAMGetFrameRGB(cam, &c));
  LCDPutImageRGB(0, 0, imagecolumns, imagerows, &c);
  LCDRefresh();
  VWDriveStraight(vw, 0.1, 0.2);
  VWDriveWait(vw);
  a = PSDInit("PSD_LEFT");
  b = PSDInit("PSD0");
  printf("sensors %d %d, unknown %d\n", a, b, PSDInit("NOTHING"));
  printf("released %d, then %d and %d\n", PSDRelease(a), PSDGet(a), PSDGet(b) > 0);
  printf("all %d %d\n", PSDRelease(), PSDGet(b));
  printf("lists %d %d\n", LCDSetList(NULL), LCDGetList() == NULL);
  printf("camera %d\n", CAMRelease(cam));
  LCDRelease();
  return 0;
}
