/**
 * Bug2 algorithm. The goal lies 2200 mm ahead of the start. Drive along the line to it (m-line);
 * at an obstacle follow its boundary until the line is met again nearer to the goal.
 */
#include "eyebot.h"

#define GOALX 2200
#define GOALY 0
#define CLOSE 60
#define KEEP 160

typedef enum { TO_GOAL, TO_WALL, FOLLOW, DONE } State;

int x, y, phi;

double dist_goal() { return sqrt((double)(GOALX - x) * (GOALX - x) + (double)(GOALY - y) * (GOALY - y)); }

int angle_goal()
{
  int a = (int)(atan2(GOALY - y, GOALX - x) * 180 / M_PI) - phi;
  while (a > 180) a -= 360;
  while (a < -180) a += 360;
  return a;
}

int main()
{
  State state = TO_GOAL;
  double hit = 0;
  int old = KEEP, l, f, steer, left_line = 0, count = 0, path = 0, lastx = 0, lasty = 0;

  VWSetPosition(0, 0, 0);
  LCDMenu("", "", "", "STOP");
  LCDLine(20, 150, 20 + GOALX / 5, 150, DARKGRAY);
  LCDCircle(20 + GOALX / 5, 150, 8, GREEN, 0);
  while (state != DONE && KEYRead() != KEY4)
  {
    VWGetPosition(&x, &y, &phi);
    LCDPixel(20 + x / 5, 150 - y / 5, WHITE);
    path += (int)sqrt((x - lastx) * (x - lastx) + (y - lasty) * (y - lasty));
    lastx = x; lasty = y;
    if (dist_goal() < 80) { state = DONE; continue; }
    f = PSDGet(PSD_FRONT);
    l = PSDGet(PSD_LEFT);
    switch (state)
    {
      case TO_GOAL:
        if (f < CLOSE + 60) { state = TO_WALL; hit = dist_goal(); VWSetSpeed(0, 0); LCDCircle(20 + x / 5, 150 - y / 5, 4, RED, 1); printf("hit  %4d %4d, goal %4.0f\n", x, y, hit); }
        else VWSetSpeed(200, angle_goal());
        break;
      case TO_WALL:
        VWTurn(-90, 90); VWWait();
        old = PSDGet(PSD_LEFT); left_line = 0; state = FOLLOW;
        break;
      case FOLLOW:
        if (abs(y) > 120) left_line = 1;
        if (left_line && abs(y) < 30 && dist_goal() < hit - 100)
        {
          state = TO_GOAL;
          printf("leave %4d %4d, goal %4.0f\n", x, y, dist_goal());
          LCDCircle(20 + x / 5, 150 - y / 5, 4, YELLOW, 1);
          VWTurn(angle_goal(), 90); VWWait();
          break;
        }
        if (f < CLOSE + 60) { VWTurn(-90, 90); VWWait(); old = PSDGet(PSD_LEFT); break; }
        if (l > 400) { VWSetSpeed(120, 45); old = KEEP; break; }   // lost the wall: curve around the corner
        steer = (l - KEEP) / 4 + 2 * (l - old);
        if (steer > 45) steer = 45;
        if (steer < -45) steer = -45;
        VWSetSpeed(150, steer);
        old = l;
        break;
      case DONE: break;
    }
    count++;
    OSWait(20);
  }
  VWSetSpeed(0, 0);
  LCDSetPrintf(18, 0, "GOAL reached: %d %d, path %d mm", x, y, path);
  printf("goal at %d %d after %d loops\n", x, y, count);
  return 0;
}
