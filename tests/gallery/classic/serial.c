/* talks to a computer that is not there */
#include "eyebot.h"

int main ()
{ char c = 'x';
  int r, out;

  printf("init %d\n", OSInitRS232(SER9600,NONE,SERIAL1) != 0);
  printf("bad interface %d, bad baud %d\n", OSInitRS232(SER9600,NONE,77), OSInitRS232(99,NONE,SERIAL1));
  OSFlushInRS232(SERIAL1); OSFlushOutRS232(SERIAL1);
  r = OSSendCharRS232('a',SERIAL1);
  printf("send %s\n", r ? "fails" : "works");
  OSSendRS232(&c,SERIAL1);
  out = OSCheckOutRS232(SERIAL1) > 0;
  printf("waiting %d out %d\n", OSCheckInRS232(SERIAL1) > 0, out);
  r = OSRecvRS232(&c,SERIAL1);
  printf("receive %s, still %c\n", r ? "nothing" : "a byte", c);
  LCDPrintf("nobody there\n");
  return 0;
}
