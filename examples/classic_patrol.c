/* Classic RoBIOS: two tasks share the screen by a semaphore. One drives to and fro before a wall,
   the other shows where the robot is. Built with eyebridge-cc --classic. */
#include "eyebot.h"

#define ROUNDS 3

struct tcb *driver, *watcher;
struct sem screen;
VWHandle vw;
PSDHandle front;
int done = 0;

void drive() {
  int i;
  for (i = 0; i < 2 * ROUNDS; i++) {
    if (i % 2 == 0)
      VWDriveStraight(vw, 0.4, 0.2);
    else
      VWDriveStraight(vw, -0.4, 0.2);
    VWDriveWait(vw);
    OSSemP(&screen);
    LCDSetPrintf(0, 0, "leg %d, wall %4d", i + 1, PSDGet(front));
    OSSemV(&screen);
    printf("leg %d: %d mm to the wall\n", i + 1, PSDGet(front));
  }
  done = 1;
  OSKill(0);
}

void watch() {
  PositionType pos;
  int column;
  while (1) {
    VWGetPosition(vw, &pos);
    column = (int)(pos.x * 200);
    OSSemP(&screen);
    LCDSetPrintf(2, 0, "x %5.2f", pos.x);
    LCDArea(0, 40, 127, 44, 0);
    LCDArea(0, 40, column > 0 ? column : 0, 44, 1);
    OSSemV(&screen);
    OSWait(10);
  }
}

int main() {
  OSMTInit(PREEMPT);
  vw = VWInit(VW_DRIVE, 1);
  front = PSDInit(PSD_FRONT);
  if (!vw || !front) OSPanic("this robot cannot patrol");
  VWStartControl(vw, 7, 0.3, 7, 0.1);
  OSSemInit(&screen, 1);
  LCDMenu("", "", "", "END");
  driver = OSSpawn("drive", drive, DEFAULT_STACKSIZE, MIN_PRI, 1);
  watcher = OSSpawn("watch", watch, DEFAULT_STACKSIZE, MIN_PRI, 2);
  if (!driver || !watcher) OSPanic("no tasks");
  OSReady(driver);
  OSReady(watcher);
  OSPermit();
  while (!done && KEYRead() != KEY4) OSWait(5);
  OSForbid();
  OSKill(watcher);
  VWRelease(vw);
  printf("patrol ended after %d s\n", OSGetCount() / 100);
  return 0;
}
