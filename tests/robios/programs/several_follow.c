// Robot 1 sets off and its program ends; robot 2 watches it go on, by radio and by its own eyes.
#include <eyebot.h>
#include <stdio.h>
#include <string.h>

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
  int x1, x2, y, z, phi;
  SIMGetRobot(1, &x1, &y, &z, &phi);
  OSWait(1000);
  SIMGetRobot(1, &x2, &y, &z, &phi);
  printf("%d said %s at %d; went on %d mm\n", sender, text, OSGetCount() / 100 * 100,
         (x2 - x1 + 5) / 10 * 10);
  return 0;
}
