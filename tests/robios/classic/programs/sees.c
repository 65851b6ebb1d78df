/* Camera and image processing. */
#include "eyebot.h"

image grey, edges, before;
colimage col;

static int sum(image* i)
{ int r, c, s = 0;
  for (r = 1; r < imagerows - 1; r++)
    for (c = 1; c < imagecolumns - 1; c++) s += (*i)[r][c];
  return s;
}

int main()
{ int version, fps, width, height, start, i;
  BYTE* bytes = (BYTE*)grey;

  printf("early %d %d\n", CAMGetFrame(&grey), CAMRelease());
  version = CAMInit(NORMAL);
  printf("camera %d\n", version < NOCAM && version < INITERROR && version >= COLCAM);
  fps = FPS60;
  while (CAMSet(fps, 0, 0)) fps++;
  CAMGet(&fps, &width, &height);
  printf("fps %d, %d x %d\n", fps == FPS15, width, height);
  CAMGetColFrame(&col, 0);
  CAMGetColFrame((colimage*)&grey, 1);
  IPColor2Grey(&col, &before);
  IPDiffer(&grey, &before, &edges);
  printf("same %d\n", sum(&edges));
  CAMSet(FPS1_875, 0, 0);
  CAMGetFrame(&grey);
  start = OSGetCount();
  CAMGetFrame(&grey);
  CAMGetFrame(&grey);
  i = OSGetCount() - start;
  printf("rate %d\n", i >= 106 && i <= 108);
  printf("sobel %d %d, laplace %d %d\n", IPSobel(&grey, &edges), sum(&edges) > 0,
         IPLaplace(&grey, &edges), sum(&edges) > 0);
  IPDither(&grey, &edges);
  for (i = 0; i < imagerows * imagecolumns; i++)
    if (((BYTE*)edges)[i] != 0 && ((BYTE*)edges)[i] != 255) break;
  printf("dithered %d\n", i);
  LCDPutGraphic(&grey);
  LCDPutColorGraphic(&col);
  printf("full %d %d %d\n", CAMGetFrameMono(bytes), CAMGetFrameRGB(col), CAMGetFrameBayer(bytes));
  printf("bad %d %d %d %d %d\n", CAMGetFrame(NULL), IPSobel(&grey, &grey), IPLaplace(NULL, &grey),
         IPDiffer(&grey, NULL, &edges), CAMMode(9));
  printf("mode %d release %d\n", CAMMode(AUTOBRIGHTNESS), CAMRelease());
  return 0;
}
