// The second of several robots computes for ever; the others count to ten.
#include <stdio.h>

#include <eyebot.h>

int main(void) {
  volatile unsigned long counter = 0;
  OSWait(100);
  while (OSMachineID() == 2) {
    for (;;) ++counter;
  }
  for (int i = 0; i < 10; ++i) OSWait(1000);
  printf("%d at %d\n", OSMachineID(), OSGetCount() / 100 * 100);
  return 0;
}
