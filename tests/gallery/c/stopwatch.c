/* everything at once: how long do things take on the robot's clock? */
#include "eyebot.h"

int t0;
void start() { t0 = OSGetCount(); }
void stop(char *what) { int t = OSGetCount() - t0; printf("%-12s %d ms\n", what, t); LCDPrintf("%-12s %d ms\n", what, t); }

int main()
{ int i, x, y, phi;
  start(); OSWait(250);                                  stop("OSWait 250");
  start(); usleep(250000);                               stop("usleep 250");
  start(); sleep(1.9);                                   stop("sleep 1.9");
  start(); for (i = 0; i < 100; i++) PSDGet(1);          stop("100 PSDGet");
  start(); for (i = 0; i < 100; i++) VWGetPosition(&x, &y, &phi); stop("100 VWGet");
  start(); for (i = 0; i < 1000; i++) KEYRead();         stop("1000 KEYRead");
  start(); VWStraight(300, 300); VWWait();               stop("300 mm");
  start(); VWTurn(-360, 90); VWWait();                   stop("360 deg");
  start(); OSWait(-5); OSWait(0);                        stop("no wait");
  return 0;
}
