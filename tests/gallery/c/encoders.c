/* drive with the motors only and do the odometry by hand */
#include "eyebot.h"

#define DIAMETER 54.0
#define TICKS 1100.0
#define BASE 90.0

float px = 0, py = 0, pphi = 0;
int oldl = 0, oldr = 0;

update()    /* called every 20 ms */
{
  int l = ENCODERRead(1), r = ENCODERRead(2);
  float dl = (l - oldl) * DIAMETER * M_PI / TICKS, dr = (r - oldr) * DIAMETER * M_PI / TICKS;
  pphi += (dr - dl) / BASE / 2;          /* half now, half later */
  px += (dl + dr) / 2 * cos(pphi);
  py += (dl + dr) / 2 * sin(pphi);
  pphi += (dr - dl) / BASE / 2;
  oldl = l; oldr = r;
}

void drive(int left, int right, int time_ms)
{
  int i;
  MOTORDrive(1, left);
  MOTORDrive(2, right);
  for (i = 0; i < time_ms / 20; i++) { usleep(17000); update(); }
}

int main()
{
  int x, y, phi, mx, my, mphi;
  ENCODERReset(1); ENCODERReset(2);
  drive(20, 20, 2000);
  drive(15, 10, 2000);
  drive(-10, 10, 1000);
  drive(30, 25, 1500);
  drive(0, 0, 200);
  VWGetPosition(&x, &y, &phi);
  mx = (int)(px + 0.5); my = (int)(py + 0.5); mphi = (int)(pphi * 180 / M_PI);
  printf("mine  %d %d %d\n", mx, my, mphi);
  printf("VW    %d %d %d\n", x, y, phi);
  LCDPrintf("mine %d %d %d\nVW   %d %d %d\n", mx, my, mphi, x, y, phi);
  if (abs(mx - x) > 10 || abs(my - y) > 10) printf("they differ!\n");

  MOTORPID(1, 4, 1, 1); MOTORPID(2, 4, 1, 1);
  MOTORSpeed(1, -10); MOTORSpeed(2, -10);     /* ticks per 1/100 s */
  sleep(2);
  MOTORSpeed(1, 0); MOTORSpeed(2, 0);
  x = oldl;
  update();
  printf("2 s at -10 ticks per 1/100 s: %d00 ticks\n", (oldl - x) / 100);
  LCDPrintf("ticks %d %d\n", oldl, oldr);
  SERVOSet(1, 128);
  return 0;
}
