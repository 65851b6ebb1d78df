#include "imgtools.h"

int threshold = 12;

Blob find_colour(BYTE *img, int hue)
{
  Blob b = {0, 0, 0};
  int x, y;
  BYTE *p = img;
  for (y = 0; y < CAMHEIGHT; y++)
    for (x = 0; x < CAMWIDTH; x++, p += 3)
    {
      int h = IPPRGB2Hue(p[0], p[1], p[2]);
      if (h && abs(h - hue) < threshold) { b.x += x; b.y += y; b.n++; }
    }
  if (b.n) { b.x /= b.n; b.y /= b.n; }
  return b;
}

void cross(int x, int y, COLOR c)
{
  LCDLine(x - 10, y, x + 10, y, c);
  LCDLine(x, y - 10, x, y + 10, c);
}
