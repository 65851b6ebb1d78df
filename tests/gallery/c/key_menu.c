/* Lab 1 - menus and keys
   every key counts, KEY3 shows a second menu, KEY4 ends */
#include "eyebot.h"

int count1 = 0;
int count2 = 0;

void second_menu()
{ char k;
  int again = 1;

  LCDMenu("Red", "Green", "Blue", "Back");
  while (again)
  { k = KEYGet();
    switch (k)
    { case KEY1: LCDSetColor(RED, BLACK);   LCDSetPrintf(4, 0, "red  "); break;
      case KEY2: LCDSetColor(GREEN, BLACK); LCDSetPrintf(4, 0, "green"); break;
      case KEY3: LCDSetColor(BLUE, WHITE);  LCDSetPrintf(4, 0, "blue "); break;
      case KEY4: again = 0; break;
    }
  }
  LCDSetColor(WHITE, BLACK);
}

int main()
{ int key;

  LCDPrintf("PRESS A KEY\n");
  LCDMenu("Plus", "Minus", "Colour", "END");
  do
  { key = KEYGet();
    if (key == KEY1) count1++;
    if (key == KEY2) count2--;
    if (key == KEY3)
    { second_menu();
      LCDMenu("Plus", "Minus", "Colour", "END");
    }
    LCDSetPrintf(2, 0, "plus %3d   minus %3d", count1, count2);
    printf("key %d: %d %d\n", key, count1, count2);
  } while (key != KEY4);
  LCDMenuI(1, "Sure?", WHITE, PURPLE);
  LCDMenuI(4, "yes", BLACK, ORANGE);
  KEYWait(ANYKEY);
  return 0;
}
