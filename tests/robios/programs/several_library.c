// Several robots that count in a library of their own.
#include <stdio.h>

#include <eyebot.h>

int own_count(void);

int main(void) {
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    count = own_count();
    OSWait(10);
  }
  printf("%d counted to %d\n", OSMachineID(), count);
  return 0;
}
