#include "eyebot.h"

BYTE mono[176*144], rgb[176*144*3], bayer[176*144];
colimage col;
image grey, back;

int main ()
{ int rate, w, h, i, n = 0, v;

  v = CAMInit(NORMAL);
  printf("camera %s\n", v >= COLCAM && v < INITERROR ? "in colour" : "bad");
  CAMGet(&rate,&w,&h);
  printf("%d x %d\n", w, h);
  CAMGetFrameMono(mono);
  CAMGetFrameRGB(rgb);
  CAMGetFrameBayer(bayer);
  for (i = 0; i < w*h; i++) n += abs(mono[i] - (rgb[3*i]+rgb[3*i+1]+rgb[3*i+2])/3) <= 1;
  printf("mono is the mean of rgb: %s\n", n > w*h*9/10 ? "yes" : "no");
  CAMGetColFrame(&col,0);
  IPColor2Grey(&col,&grey);
  CAMGetFrame(&back);
  printf("grey twice: %d\n", abs(grey[31][41] - back[31][41]) < 3);
  LCDPutGraphic(&grey);
  CAMRelease();
  return 0;
}
