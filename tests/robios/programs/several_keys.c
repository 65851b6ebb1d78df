// Several robots: which keys and touches each of them gets.
#include <stdio.h>

#include <eyebot.h>

int main(void) {
  int keys = 0;
  int x = -1;
  int y = -1;
  for (int i = 0; i < 50; ++i) {
    const int key = KEYRead();
    if (key != 0) keys |= key;
    int at_x;
    int at_y;
    if (KEYReadXY(&at_x, &at_y) == 0 && at_x >= 0) {
      x = at_x;
      y = at_y;
    }
    OSWait(100);
  }
  printf("%d: keys %d touch %d:%d\n", OSMachineID(), keys, x, y);
  return 0;
}
