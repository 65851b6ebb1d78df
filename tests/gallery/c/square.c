#include "eyebot.h"
#define SIDE 500
#define SPEED 200

void show(int i)
{
  int x, y, phi;
  VWGetPosition(&x, &y, &phi);
  LCDSetPrintf(i, 0, "corner %d: x=%4d y=%4d phi=%4d", i, x, y, phi);
  printf("corner %d: x=%d y=%d phi=%d\n", i, x, y, phi);
}

int main()
{
  int i;
  float angle = 90.5;   // they say 90 is not enough

  VWSetPosition(0, 0, 0);
  LCDMenu("", "", "", "END");
  for (i = 1; i <= 4; i++)
  {
    VWStraight(SIDE, SPEED);
    VWWait();
    VWTurn(angle, 45);
    VWWait();
    show(i);
  }
  // and once backwards with a negative turn
  VWStraight(-SIDE/2, -SPEED);
  VWWait();
  VWTurn(-180, -60);
  VWWait();
  show(5);
  KEYWait(KEY4);
  return 0;
}
