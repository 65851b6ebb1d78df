// camera: find the red can by its hue, drive there
#include "eyebot.h"

#define MIN_COL 3

int column[QQVGA_X];

int main()
{ BYTE img[QQVGA_SIZE];
  BYTE h[QQVGA_PIXELS], s[QQVGA_PIXELS], in[QQVGA_PIXELS];
  int x, y, max, pos, frames = 0, found = 0, dist;

  LCDMenu("", "", "", "END");
  CAMInit(QQVGA);
  LCDImageStart(10, 10, QQVGA_X, QQVGA_Y);
  do
  { CAMGet(img);
    frames++;
    LCDImage(img);
    IPCol2HSI(img, h, s, in);
    for (x = 0; x < QQVGA_X; x++)       // column histogram
    { column[x] = 0;
      for (y = 0; y < QQVGA_Y; y++)
        if (h[y * QQVGA_X + x] > 35 && h[y * QQVGA_X + x] < 52 && s[y * QQVGA_X + x] > 150) column[x]++;
    }
    max = 0; pos = -1;
    for (x = 0; x < QQVGA_X; x++) if (column[x] > max) { max = column[x]; pos = x; }
    LCDArea(10, 140, 170, 200, BLACK, 1);
    for (x = 0; x < QQVGA_X; x++) LCDLine(10 + x, 200, 10 + x, 200 - column[x] / 2, RED);
    dist = PSDGet(PSD_FRONT);
    LCDSetPrintf(15, 0, "max %3d at %4d, front %4d ", max, pos, dist);
    if (max < MIN_COL) VWSetSpeed(0, 40);               // search
    else if (dist < 120) { VWSetSpeed(0, 0); found = 1; }
    else VWSetSpeed(150, (QQVGA_X / 2 - pos) / 2);
  } while (!found && KEYRead() != KEY4 && frames < 600);
  VWSetSpeed(0, 0);
  printf(found ? "found the can\n" : "no can\n");
  LCDSetPrintf(16, 0, found ? "FOUND" : "nothing");
  return 0;
}
