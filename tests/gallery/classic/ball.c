/* find something red by its colour, centre pixel decides */
#include "eyebot.h"

colimage img;
image grey;

int main ()
{ int version, r, c, n, sum, i;
  VWHandle vw;

  version = CAMInit(NORMAL);
  if (version == NOCAM) { LCDPrintf("No camera\a\n"); return 1; }
  while (version >= INITERROR) { OSWait(CAMWAIT); version = CAMInit(NORMAL); }
  printf("colour camera: %d\n", version >= COLCAM);
  CAMMode(AUTOBRIGHTNESS);
  CAMSet(FPS1_875,0,0);
  vw = VWInit(VW_DRIVE,1);
  VWStartControl(vw,7,0.3,7,0.1);
  for (i=0; i<60; i++)
  { CAMGetColFrame(&img,0);
    n = sum = 0;
    for (r=1; r<61; r++)
      for (c=1; c<81; c++)
        if (img[r][c][0] > 120 && img[r][c][1] < 80 && img[r][c][2] < 80) { n++; sum += c; }
    CAMGetColFrame((colimage*)&grey,1);
    LCDPutGraphic(&grey);
    if (n > 8 && abs(sum/n - 41) < 4) break;
    VWDriveTurn(vw, n > 8 ? (41 - sum/n) * 0.01 : 0.3, 0.6);
    VWDriveWait(vw);
  }
  LCDSetPrintf(0,10,"n%4d",n);
  LCDSetPrintf(1,10,"%s",i < 60 ? "FOUND" : "none");
  printf("%s\n",i < 60 ? "found" : "nothing");
  VWRelease(vw);
  CAMRelease();
  return 0;
}
