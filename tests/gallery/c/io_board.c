/* digital and analog lines */
#include "eyebot.h"

int main()
{
  int i, volt, n;
  BYTE sample[200];

  volt = ANALOGVoltage();
  LCDPrintf("battery %d.%02d V\n", volt / 100, volt % 100);
  printf("battery %s\n", volt > 600 ? "good" : "low");
  for (i = 1; i <= 8; i++) LCDPrintf("analog %d: %d\n", i, ANALOGRead(i));
  DIGITALSetup(1, 'I');
  DIGITALSetup(9, 'o');
  for (i = 0; i < 6; i++) { DIGITALWrite(9, i % 2); OSWait(100); }
  printf("line 9: %d, line 1: %d\n", DIGITALRead(9), DIGITALRead(1));
  DIGITALWrite(9, 0);
  printf("line 9: %d, all %s\n", DIGITALRead(9), DIGITALReadAll() >= 0 ? "fine" : "bad");
  i = DIGITALSetup(2, 'x');
  printf("line 17: %d, letter x: %d\n", DIGITALWrite(17, 1), i);
  ANALOGRecord(8, 200);
  OSWait(300);
  n = ANALOGTransfer(sample);
  printf("%d samples, first %d\n", n, sample[0]);
  return 0;
}
