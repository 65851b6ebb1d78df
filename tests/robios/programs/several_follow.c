// Robot 1 sets off and its program ends; robot 2 watches it go on, by radio and by its own eyes.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <eyebot.h>

int main(void) {
  RADIOInit();
  if (OSMachineID() == 1) {
    VWSetSpeed(200, 0);
    OSWait(500);
    RADIOSend(2, "gone");
    return 0;
  }
  char text[20];
  int sender = 0;
  RADIOReceive(&sender, text, sizeof text);
  int x1, y1, x2, y2, z, phi;
  SIMGetRobot(1, &x1, &y1, &z, &phi);
  OSWait(1000);
  SIMGetRobot(1, &x2, &y2, &z, &phi);
  printf("%d said %s at %d; went on %.0f mm\n", sender, text, OSGetCount() / 100 * 100,
         hypot(x2 - x1, y2 - y1));
  return 0;
}
