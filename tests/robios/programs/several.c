// What each of several robots has for itself: variables, time, LCD, number, the library's
// variables.
#include <stdio.h>

#include <eyebot.h>

int counted;                     // zero at first
static int mine[3] = {1, 2, 3};  // with values at first

int main(int argc, char** argv) {
  const int id = OSMachineID();
  static int calls;
  for (int i = 0; i < 5 + id; ++i) {
    ++counted;
    ++calls;
    mine[i % 3] += id;
    VWSetSpeed(20 * id, 0);
    OSWait(100);
  }
  const int count = OSGetCount() / 100 * 100;
  int x, y, phi;
  VWGetPosition(&x, &y, &phi);
  LCDSetPrintf(0, 0, "robot %d", id);
  CAMInit(id == 1 ? QQVGA : QVGA);
  printf("%d: counted %d calls %d mine %d camera %d x %d at %d %s\n", id, counted, calls, mine[0],
         CAMWIDTH, x / 10 * 10, count, argc > 1 ? argv[1] : "alone");
  return 0;
}
