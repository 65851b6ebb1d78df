#include "eyebot.h"
#include <math.h>

#define PI 3.14159265

int house[5][4] = {{40,120,40,200}, {40,200,140,200}, {140,200,140,120}, {140,120,40,120}, {40,120,90,80}};

int main()
{
  int i, x, y, w, h;
  COLOR c;
  COLOR cols[18] = {RED,GREEN,BLUE,WHITE,GRAY,SILVER,LIGHTGRAY,DARKGRAY,NAVY,CYAN,TEAL,MAGENTA,PURPLE,MAROON,YELLOW,OLIVE,ORANGE,BLACK};

  LCDGetSize(&w, &h);
  LCDPrintf("LCD is %d x %d", w, h);

  // the house
  for (i = 0; i < 5; i++) LCDLine(house[i][0], house[i][1], house[i][2], house[i][3], YELLOW);
  LCDLine(90, 80, 140, 120, YELLOW);
  LCDArea(80, 160, 100, 200, MAROON, 1);
  LCDArea(50, 135, 70, 150, CYAN, 0);

  // sun with rays
  LCDCircle(220, 70, 25, ORANGE, 1);
  for (i = 0; i < 360; i += 30)
  {
    x = 220 + 45 * cos(i * PI / 180);
    y = 70 + 45 * sin(i * PI / 180);
    LCDLine(220 + 30 * cos(i * PI / 180), 70 + 30 * sin(i * PI / 180), x, y, ORANGE);
  }
  LCDCircle(220, 70, 50, RED, 0);

  // all the colours there are
  for (i = 0; i < 18; i++) LCDArea(300 + (i % 6) * 30, 40 + (i / 6) * 30, 325 + (i % 6) * 30, 65 + (i / 6) * 30, cols[i], 1);

  // a sine made of pixels
  for (x = 0; x < w; x++)
  {
    y = 280 - 40 * sin(x * 4 * PI / w);
    LCDPixel(x, y, GREEN);
    LCDPixel(x, 280, DARKGRAY);
  }
  c = LCDGetPixel(220, 70);
  printf("middle of the sun: %06X\n", c);
  printf("outside: %06X\n", LCDGetPixel(-5, 1000));
  LCDLine(-50, -50, 2000, 700, WHITE);  // too long on purpose
  LCDMenu("", "", "", "END");
  KEYWait(KEY4);
  return 0;
}
