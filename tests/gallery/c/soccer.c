/* Soccer: go behind the ball, then push it into the blue goal */
#include "eyebot.h"

#define GOALX 3050
#define GOALY 760

int rx, ry, rphi, bx, by, z, dummy;

void where()
{
  SIMGetRobot(0, &rx, &ry, &z, &rphi);
  SIMGetObject(1, &bx, &by, &z, &dummy);
  LCDArea(20, 60, 330, 212, OLIVE, 1);
  LCDArea(20, 60, 330, 212, WHITE, 0);
  LCDCircle(20 + bx / 10, 212 - by / 10, 3, ORANGE, 1);
  LCDCircle(20 + rx / 10, 212 - ry / 10, 9, BLUE, 1);
}

void go(int x, int y, int v)
{
  int a, d;
  where();
  a = (int)(atan2(y - ry, x - rx) * 180 / M_PI) - rphi;
  while (a > 180) a -= 360;
  while (a < -180) a += 360;
  VWTurn(a, 100);
  VWWait();
  d = (int)sqrt((double)(x - rx) * (x - rx) + (double)(y - ry) * (y - ry));
  VWStraight(d, v);
  VWWait();
}

int main()
{
  int tries = 0, behindx, behindy;
  double a;

  LCDMenu("KICK", "", "", "END");
  KEYWait(KEY1);
  where();
  while (bx < 2920 && tries < 6)
  {
    tries++;
    a = atan2(GOALY - by, GOALX - bx);
    behindx = bx - 300 * cos(a);
    behindy = by - 300 * sin(a);
    go(behindx, behindy, 300);
    where();
    LCDSetPrintf(0, 0, "try %d, ball at %d %d  ", tries, bx, by);
    go(bx + 400 * cos(a), by + 400 * sin(a), 500);
    OSWait(1500);         // let it roll
    where();
    printf("try %d: ball at %d %d\n", tries, bx, by);
  }
  if (bx >= 2920) { LCDSetPrintf(1, 0, "GOAL !!!"); printf("goal after %d tries\n", tries); }
  else printf("missed\n");
}
