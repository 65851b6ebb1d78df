/* image processing lab: gray, Laplace, Sobel, overlay, files. Big images on the stack. */
#include "eyebot.h"

int main()
{
  BYTE col[QVGA_SIZE], over[QVGA_SIZE];
  BYTE gray[QVGA_PIXELS], lap[QVGA_PIXELS], sob[QVGA_PIXELS], back[QVGA_PIXELS];
  BYTE big[VGA_SIZE];
  int i, n = 0, r;

  memset(lap, 0, sizeof(lap)); memset(sob, 0, sizeof(sob)); memset(big, 0, sizeof(big));
  CAMInit(QVGA);
  CAMGet(col);
  IPCol2Gray(col, gray);
  IPLaplace(gray, lap);
  IPSobel(gray, sob);
  for (i = 0; i < QVGA_PIXELS; i++) if (sob[i] > 60) { sob[i] = 255; n++; } else sob[i] = 0;
  IPOverlayGray(gray, sob, RED, over);
  LCDImageStart(0, 0, QVGA_X, QVGA_Y);
  LCDImage(over);
  LCDImageStart(325, 0, QVGA_X, QVGA_Y);
  LCDImageGray(lap);
  printf("edges: %s\n", n > 200 && n < 20000 ? "some" : "strange");

  printf("write %d %d\n", IPWriteFile("over.ppm", over), IPWriteFileGray("gray.pgm", gray));
  r = IPReadFile("gray.pgm", back);
  for (i = 0; i < QVGA_PIXELS && back[i] == gray[i]; i++);
  printf("read %d, %s\n", r, i == QVGA_PIXELS ? "the same" : "different");
  printf("missing file: %d\n", IPReadFile("nothere.ppm", big));
  remove("over.ppm"); remove("gray.pgm");

  CAMInit(VGA);
  CAMGet(big);
  printf("VGA frame: %dx%d, %d bytes\n", CAMWIDTH, CAMHEIGHT, CAMSIZE);
  CAMRelease();
  printf("after release: %d\n", CAMGet(big) != 0);
  LCDMenu("", "", "", "END");
  KEYWait(KEY4);
}
