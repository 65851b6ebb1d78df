#include "eyebot.h"

int main ()
{ LCDPrintf("Hello !\n");
  LCDPutString("EyeBot ");
  LCDPutInt(OSMachineID());
  LCDSetPos(3,0);
  LCDPutHex1(255); LCDPutChar(' '); LCDPutIntS(42,5);
  LCDSetString(4,2,"row 4");
  LCDSetChar(5,15,'*');
  LCDPutChar(NL);
  LCDPutFloat(3.14);
  LCDMenu("A","B","C","END");
  printf("waiting\n");
  KEYWait(KEY4);
  LCDSetPos(2,0);
  LCDPrintf("bye");
  return 0;
}
