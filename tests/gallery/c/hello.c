// my first robot program
#include "eyebot.h"

int main()
{
  LCDPrintf("Hello World!\n");
  LCDPrintf("I am robot %d\n", OSMachineID());
  LCDSetPrintf(5, 10, "row 5, column 10");
  LCDMenu("", "", "", "END");
  printf("Hello on the terminal\n");
  KEYWait(KEY4);
}
