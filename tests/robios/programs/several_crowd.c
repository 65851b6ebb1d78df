// One of many robots that use everything at once, each with a timer of its own. Robot 3 ends at
// once, robot 5 aborts on its way.
#include <eyebridge.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <eyebot.h>

static int seen;  // of the robot's own variables
static BYTE image[QQVGA_SIZE];

static void tick(void) { LCDPixel(10, 10, RED); }

static void watches(int i) {
  int x, y, z, phi;
  SIMGetRobot(i % 8 + 1, &x, &y, &z, &phi);
  LCDSetPrintf(i % 10, 0, "%d %d", PSDGet(PSD_LEFT), KEYRead());
  if (strlen(EYEBRIDGELastError()) == 0) ++seen;
}

static void drives(int id) {
  static int scan[360];
  char text[40];
  int x, y, phi, from;
  for (int i = 0; i < 20; ++i) {
    watches(i);
    VWSetSpeed(100, i % 2 ? 60 : -60);
    VWGetPosition(&x, &y, &phi);
    snprintf(text, sizeof text, "%d at %d %d", id, x, y);
    RADIOSend(i % 8 + 1, text);
    if (RADIOCheck() > 0) RADIOReceive(&from, text, sizeof text);
    LCDPrintf("%d\n", PSDGet(PSD_FRONT));
    if (i % 5 == 0) LIDARGet(scan);
    if (i == 10) SIMSetObject(1, 200 + 70 * id, 2700, 0, 0);
    if (i == 12 && id == 5) abort();
    OSWait(5);
  }
}

int main(void) {
  const int id = OSMachineID();
  if (id == 3) return 0;
  RADIOInit();
  const TIMER timer = OSAttachTimer(10, tick);
  drives(id);
  if (id % 16 == 1 && CAMInit(QQVGA) == 0) LCDImage((CAMGet(image), image));
  OSDetachTimer(timer);
  printf("robot %d saw %d, %s\n", id, seen, strlen(EYEBRIDGELastError()) == 0 ? "well" : "failing");
  return 0;
}
