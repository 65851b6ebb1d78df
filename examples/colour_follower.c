/* Turns until it sees something red, drives up to it and stops 120 mm before it.
 *
 * Camera at QQVGA; red pixels are found by hue, and their mean column steers. */
#include "eyebot.h"

#define STOP_MM 120
#define LEAST_PIXELS 12
#define RED_HUE 43 /* RoBIOS hues run from 1 to 255; red is 43 */
#define HUE_WIDTH 12

static BYTE image[QQVGA_SIZE];

/* Counts red pixels and gives their mean column; 0 when there are too few. */
static int find_red(int* column) {
  long sum = 0;
  int count = 0;
  int i;

  for (i = 0; i < QQVGA_PIXELS; i++) {
    BYTE hue, saturation, intensity;
    IPPRGB2HSI(image[3 * i], image[3 * i + 1], image[3 * i + 2], &hue, &saturation, &intensity);
    if (saturation > 120 && intensity > 20 && abs(hue - RED_HUE) < HUE_WIDTH) {
      sum += i % QQVGA_X;
      count++;
    }
  }
  if (count < LEAST_PIXELS) return 0;
  *column = (int)(sum / count);
  return count;
}

int main() {
  int column = 0;
  int front = 0;

  LCDMenu("", "", "", "END");
  if (CAMInit(QQVGA) != 0) {
    LCDPrintf("no camera\n");
    return 1;
  }
  do {
    CAMGet(image);
    LCDImageStart(0, 0, QQVGA_X, QQVGA_Y);
    LCDImage(image);
    if (find_red(&column) == 0) {
      VWSetSpeed(0, 45);
      continue;
    }
    LCDLine(column, 0, column, QQVGA_Y - 1, YELLOW);
    front = PSDGet(PSD_FRONT);
    if (abs(column - QQVGA_X / 2) < 12 && front < STOP_MM) {
      VWSetSpeed(0, 0);
      LCDSetPrintf(12, 0, "found it, %d mm ahead", front);
      printf("found it, %d mm ahead\n", front);
      CAMRelease();
      return 0;
    }
    VWSetSpeed(front < STOP_MM ? 0 : 120, (QQVGA_X / 2 - column) / 2);
  } while (KEYRead() != KEY4 && OSGetCount() < 120000);
  VWSetSpeed(0, 0);
  CAMRelease();
  printf("found nothing red\n");
  return 1;
}
