/* waits for its timer in an empty loop */
#include "eyebot.h"

int count = 0;

void tick() { count++; }

int main()
{
  TIMER t;
  t = OSAttachTimer(10, &tick);
  VWSetSpeed(100, 0);
  while (count < 100) { }        // one second
  VWSetSpeed(0, 0);
  OSDetachTimer(t);
  LCDPrintf("%s", count >= 100 ? "a second is over" : "too early");
  return 0;
}
