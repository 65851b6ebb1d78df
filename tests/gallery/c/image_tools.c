/* all the small image functions, with pictures made by hand */
#include "eyebot.h"

BYTE r[QQVGA_PIXELS], g[QQVGA_PIXELS], b[QQVGA_PIXELS], gray[QQVGA_PIXELS];
BYTE col[QQVGA_SIZE], col2[QQVGA_SIZE], over[QQVGA_SIZE];

int main()
{
  int x, y, i;
  BYTE h, s, v, p, q, t;
  COLOR c;

  printf("size %d, bad size %d\n", IPSetSize(QQVGA), IPSetSize(99));
  for (y = 0; y < QQVGA_Y; y++)
    for (x = 0; x < QQVGA_X; x++)
    { i = y * QQVGA_X + x;
      r[i] = 255 * x / QQVGA_X;
      g[i] = 255 * y / QQVGA_Y;
      b[i] = 255 - r[i];
      gray[i] = (x / 20 + y / 20) % 2 ? 200 : 0;      // chess board
    }
  IPRGB2Col(r, g, b, col);
  IPGray2Col(gray, col2);
  IPOverlay(col, col2, over);

  LCDClear();
  LCDImageSize(QQVGA);
  LCDImage(col);                         // top left
  LCDImageStart(180, 0, QQVGA_X, QQVGA_Y);
  LCDImage(col2);
  LCDImageStart(360, 0, QQVGA_X, QQVGA_Y);
  LCDImage(over);

  LCDSetMode(LCD_NOAUTOREFRESH);
  LCDImageStart(0, 140, QQVGA_X, QQVGA_Y);
  IPCol2Gray(col, gray);
  LCDImageGray(gray);
  LCDRefresh();
  LCDSetMode(LCD_AUTOREFRESH);

  c = IPPRGB2Col(10, 20, 30);
  IPPCol2RGB(c, &p, &q, &t);
  printf("%06X = %d %d %d\n", c, p, q, t);
  COLOR all[6] = {RED, GREEN, BLUE, YELLOW, GRAY, BLACK};
  for (i = 0; i < 6; i++)
  { IPPCol2HSI(all[i], &h, &s, &v);
    IPPCol2RGB(all[i], &p, &q, &t);
    printf("%06X: hue %3d sat %3d int %3d, hue again %d\n", all[i], h, s, v, IPPRGB2Hue(p, q, t));
    LCDSetPrintf(20, 12 * i, "hue %3d", h);
    LCDArea(12 * 7 * i, 320, 12 * 7 * i + 50, 340, all[i], 1);
  }
  IPPRGB2HSI(200, 100, 50, &h, &s, &v);
  printf("brown: %d %d %d\n", h, s, v);
  return 0;
}
