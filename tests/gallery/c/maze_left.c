// maze: always left hand rule
#include "eyebot.h"
#define CELL 360
#define WALL 300

int dirx[4] = {1, 0, -1, 0}, diry[4] = {0, 1, 0, -1};

main()
{
  int steps, dir = 0, cx = 0, cy = 0;
  int left, front, right;

  LCDMenu("GO", "", "", "END");
  KEYWait(KEY1);
  for (steps = 0; steps < 40; steps++)
  {
    left  = PSDGet(PSD_LEFT)  > WALL;
    front = PSDGet(PSD_FRONT) > WALL;
    right = PSDGet(PSD_RIGHT) > WALL;
    if (left)        { VWTurn( 90, 90); VWWait(); dir = (dir + 1) % 4; }
    else if (front)  ;
    else if (right)  { VWTurn(-90, 90); VWWait(); dir = (dir + 3) % 4; }
    else             { VWTurn(180, 90); VWWait(); dir = (dir + 2) % 4; }
    VWStraight(CELL, 300);
    VWWait();
    cx += dirx[dir]; cy += diry[dir];
    LCDSetPrintf(steps % 20, (steps / 20) * 20, "%2d: cell %2d,%2d", steps, cx, cy);
    if (KEYRead() == KEY4) exit(0);
    if (cx == 0 && cy == 0) break;
  }
  printf("home again after %d steps\n", steps + 1);
  VWSetSpeed(0, 0);
}
