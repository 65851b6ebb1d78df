/* Every family of calls that a first text book uses, as a student writes them. */
#include "eyebot.h"

BYTE img[QVGA_SIZE], gray[QVGA_PIXELS], edges[QVGA_PIXELS];

int main() {
  int x, y, phi, i, key;
  long sum = 0;

  LCDMenu("GO", "", "", "END");
  key = KEYWait(ANYKEY);
  printf("key %d\n", key);
  VWSetPosition(0, 0, 0);
  VWStraight(300, 150);
  VWWait();
  VWTurn(90, 60);
  VWWait();
  VWGetPosition(&x, &y, &phi);
  LCDPrintf("at %d %d %d\n", x, y, phi);
  printf("at %d %d %d, wall ahead at %d\n", x, y, phi, PSDGet(PSD_FRONT));
  CAMInit(QVGA);
  CAMGet(img);
  IPCol2Gray(img, gray);
  IPSobel(gray, edges);
  LCDImageStart(0, 100, QVGA_X, QVGA_Y);
  LCDImageGray(edges);
  for (i = 0; i < QVGA_PIXELS; i++) sum += edges[i];
  printf("edges: %s\n", sum > 0 ? "some" : "none");
  printf("size %d %d %d %d\n", CAMWIDTH, CAMHEIGHT, CAMPIXELS, CAMSIZE);
  KEYWait(KEY4);
  return 0;
}
