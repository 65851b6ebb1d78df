// occupancy map from the lidar, shown as a binary image 128x128 (1 pixel = 25 mm)
#include "eyebot.h"
#define SIZE 128
#define SCALE 25

BYTE map[SIZE * SIZE];
int scan[360];

void add_scan()
{
  int i, x, y, phi, px, py;
  double a;
  SIMGetRobot(0, &x, &y, &px, &phi);
  LIDARGet(scan);
  for (i = 0; i < 360; i++)
  {
    if (scan[i] >= 9999) continue;
    a = (180 - i + phi) * M_PI / 180;      // 180 is the front, 90 left
    px = (x + scan[i] * cos(a)) / SCALE;
    py = (y + scan[i] * sin(a)) / SCALE;
    if (px >= 0 && py >= 0 && px < SIZE && py < SIZE) map[(SIZE - 1 - py) * SIZE + px] = 1;
  }
}

int main()
{
  int n, i, sum = 0, part[8];

  LCDMenu("", "", "", "END");
  LCDImageStart(20, 20, SIZE, SIZE);
  for (n = 0; n < 6; n++)
  {
    add_scan();
    LCDImageBinary(map);
    VWTurn(60, 60); VWWait();
    if (n == 2) { VWStraight(300, 200); VWWait(); }
  }
  for (i = 0; i < SIZE * SIZE; i++) sum += map[i];
  printf("%d cells are occupied\n", sum);
  printf("front %d left %d right %d back %d\n", scan[180], scan[90], scan[270], scan[0]);
  LIDARSet(180, 0, 8);          // only 8 values now
  LIDARGet(part);
  for (i = 0; i < 8; i++) printf("%d ", part[i]);
  printf("\n");
  KEYWait(KEY4);
}
