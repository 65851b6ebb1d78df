// turns the camera with servo 1 and 2 and puts a strip of pictures side by side
#include "eyebot.h"

BYTE img[QQVGA_SIZE], strip[480 * 120 * 3];

int main()
{
  int i, x, y, angle;
  long sum[3] = {0, 0, 0};

  if (CAMInit(QQVGA) != CAM_SUCCESS) { LCDPrintf("No camera!\n"); exit(1); }
  for (i = 0; i < 3; i++)
  {
    angle = 60 + 68 * i;          // 60, 128, 196
    SERVOSet(1, angle);
    OSWait(500);
    CAMGet(img);
    for (y = 0; y < 120; y++)
      for (x = 0; x < 160; x++)
      {
        memcpy(&strip[3 * (480 * y + 160 * i + x)], &img[3 * (160 * y + x)], 3);
        sum[i] += img[3 * (160 * y + x)];
      }
  }
  LCDImageStart(0, 0, 480, 120);
  LCDImage(strip);
  SERVOSet(2, 180); OSWait(200);
  CAMGet(img);
  LCDImageStart(0, 130, QQVGA_X, QQVGA_Y);
  LCDImage(img);
  LCDSetPrintf(20, 0, "servo 60, 128, 196, then tilted");
  printf("three different pictures: %d\n", sum[0] != sum[1] && sum[1] != sum[2]);
  SERVOSet(1, 128); SERVOSet(2, 128);
  LCDMenu("", "", "", "END");
  KEYWait(KEY4);
  return 0;
}
