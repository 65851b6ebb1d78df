/* which fonts, which sizes, does it scroll? */
#include "eyebot.h"

int main()
{
  int sizes[] = {8, 10, 12, 14, 18, 24};
  char* names[] = {"HELVETICA", "TIMES", "COURIER"};
  int f, i, row, col;

  for (f = HELVETICA; f <= COURIER; f++)
  {
    LCDSetFont(f, NORMAL);
    LCDPrintf("%s normal ", names[f]);
    LCDSetFont(f, BOLD);
    LCDPrintf("bold ");
    LCDSetFont(f, ITALICS);
    LCDPrintf("italics\n");
  }
  LCDSetFont(HELVETICA, NORMAL);
  for (i = 0; i < 6; i++)
  {
    if (LCDSetFontSize(sizes[i])) printf("size %d refused\n", sizes[i]);
    LCDSetPrintf(6, 10 * i / (1 + i / 3), "S%d", sizes[i]);
  }
  printf("size 13: %d\n", LCDSetFontSize(13));
  LCDSetFontSize(12);
  LCDMenu("scroll", "stay", "clear", "END");

  KEYWait(KEY1);
  LCDSetPos(20, 0);
  for (i = 1; i <= 8; i++) LCDPrintf("scrolling line %d\n", i);
  LCDGetPos(&row, &col);
  printf("cursor at %d %d\n", row, col);

  KEYWait(KEY2);
  LCDSetMode(LCD_NOSCROLLING);
  for (i = 1; i <= 5; i++) LCDPrintf("line that stays %d\n", i);
  LCDGetPos(&row, &col);
  printf("cursor at %d %d\n", row, col);
  LCDSetPrintf(0, 40, "%-10s|%5d|%5.2f|%c|%x", "text", 42, 3.14159, 'X', 255);
  KEYWait(KEY4);
  return 0;
}
