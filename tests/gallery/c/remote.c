// drive with the TV remote control
#include "eyebot.h"

int main()
{
  int code, x, y, phi, run = 1;

  printf("remote %s\n", IRTVGetStatus() ? "on" : "off");
  IRTVFlush();
  LCDPrintf("press OK\n");
  while (IRTVGet() != IRTV_OK);
  while (run)
  {
    code = IRTVRead();
    switch (code)
    {
      case IRTV_UP:    VWSetSpeed(200, 0); break;
      case IRTV_DOWN:  VWSetSpeed(-100, 0); break;
      case IRTV_LEFT:  VWSetSpeed(0, 45); break;
      case IRTV_RIGHT: VWSetSpeed(0, -45); break;
      case IRTV_0:     VWSetSpeed(0, 0); break;
      case IRTV_RED:
      case IRTV_POWER: run = 0; break;
    }
    if (code) { LCDPrintf("%c ", code); printf("%c", code); }
    OSWait(50);
  }
  VWSetSpeed(0, 0);
  VWGetPosition(&x, &y, &phi);
  printf("\nat %d %d %d\n", x, y, phi);
}
