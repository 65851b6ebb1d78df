// Tells when its robot came, and how far it got in a second. Its words: a speed, and how it ends.
#include <stdio.h>
#include <stdlib.h>

#include <eyebot.h>

int main(int argc, char** argv) {
  const int came = OSGetCount();
  int x, y, z, phi;
  SIMGetRobot(0, &x, &y, &z, &phi);
  const int start = x;
  const int ahead = PSDGet(PSD_FRONT);
  VWSetSpeed(argc > 1 ? atoi(argv[1]) : 200, 0);
  OSWait(1000);
  SIMGetRobot(0, &x, &y, &z, &phi);
  printf("%d came at %d to %d, saw %d, drove %d\n", OSMachineID(), came, start, ahead,
         (x - start + 2) / 10 * 10);
  return argc > 2 ? atoi(argv[2]) : 0;
}
