/* Camera and image processing. */
#include "eyebot.h"
#include "tell.h"

image grey, edges, before;
colimage col;

static int sum(image* i) {
  int r, c, s = 0;
  for (r = 1; r < imagerows - 1; r++)
    for (c = 1; c < imagecolumns - 1; c++) s += (*i)[r][c];
  return s;
}

int main() {
  int version, fps, width, height, start, i;
  BYTE* bytes = (BYTE*)grey;

  TELL("early", CAMGetFrame(&grey));
  TELL("early", CAMRelease());
  version = CAMInit(NORMAL);
  TELL("camera", version < INITERROR && version >= COLCAM);
  fps = FPS60;
  while (CAMSet(fps, 0, 0)) fps++;
  CAMGet(&fps, &width, &height);
  printf("fps %d, %d x %d\n", fps == FPS15, width, height);
  CAMGetColFrame(&col, 0);
  CAMGetColFrame((colimage*)&grey, 1);
  IPColor2Grey(&col, &before);
  IPDiffer(&grey, &before, &edges);
  TELL("difference", sum(&edges));
  CAMSet(FPS1_875, 0, 0);
  CAMGetFrame(&grey);
  start = OSGetCount();
  CAMGetFrame(&grey);
  CAMGetFrame(&grey);
  i = OSGetCount() - start;
  TELL("rate", i >= 106 && i <= 108);
  TELL("sobel", IPSobel(&grey, &edges));
  TELL("edges", sum(&edges) > 0);
  TELL("laplace", IPLaplace(&grey, &edges));
  TELL("edges", sum(&edges) > 0);
  IPDither(&grey, &edges);
  for (i = 0; i < imagerows * imagecolumns; i++)
    if (((BYTE*)edges)[i] != 0 && ((BYTE*)edges)[i] != 255) break;
  TELL("dithered", i);
  LCDPutColorGraphic(&col);
  LCDPutGraphic(&grey);
  TELL("shown", LCDGetPixel(20, 40) == (edges[21][41] == 0));
  TELL("mono", CAMGetFrameMono(bytes));
  TELL("rgb", CAMGetFrameRGB(col));
  TELL("bayer", CAMGetFrameBayer(bytes));
  TELL("null", CAMGetFrame(NULL));
  TELL("same image", IPSobel(&grey, &grey));
  TELL("null", IPLaplace(NULL, &grey));
  TELL("null", IPDiffer(&grey, NULL, &edges));
  TELL("mode", CAMMode(AUTOBRIGHTNESS));
  TELL("bad mode", CAMMode(9));
  TELL("release", CAMRelease());
  return 0;
}
