/* Mako dives to the middle of the pool, swims a square, measures the walls, comes up again */
#include "eyebot.h"
#define LEFT  1
#define FRONT 2
#define RIGHT 3
#define BACK  4
#define PSD_DOWN 6

void report(const char* what)
{ int x, y, z, phi;
  SIMGetRobot(0, &x, &y, &z, &phi);
  LCDPrintf("%s: %d %d %d, %d deg\n", what, x, y, z, phi);
  printf("%s: x=%d y=%d z=%d phi=%d  ahead=%d right=%d below=%d\n", what, x, y, z, phi,
         PSDGet(PSD_FRONT), PSDGet(3), PSDGet(PSD_DOWN));
}

void dive(int speed)
{ MOTORDrive(FRONT, speed);
  MOTORDrive(BACK, speed);
}

void swim(int left, int right)
{ MOTORDrive(LEFT, left);
  MOTORDrive(RIGHT, right);
}

// hold the depth: a bit of thrust against the buoyancy, more when it is off
void hold(int below, int ms)
{ int t;
  for (t = 0; t < ms; t += 100)
  { dive(-8 + (below - PSDGet(PSD_DOWN)) / 5);
    OSWait(100);
  }
}

int main()
{ int i;
  report("surface");
  dive(-100);
  while (PSDGet(PSD_DOWN) > 900) OSWait(50);
  dive(60);                          // brake
  OSWait(400);
  hold(770, 3000);
  report("middle");
  for (i = 1; i <= 4; i++)
  { swim(60, 60);
    hold(770, 6000);
    swim(0, 0);
    hold(770, 6000);                 // it glides on
    swim(-48, 48);
    hold(770, 4000);
    swim(0, 0);
    hold(770, 4000);
    report("corner");
  }
  dive(100);
  while (PSDGet(PSD_DOWN) < 1500) OSWait(50);
  dive(0);
  OSWait(5000);
  report("up again");
  return 0;
}
