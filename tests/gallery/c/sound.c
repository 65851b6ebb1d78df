#include "eyebot.h"

int main()
{
  int i, t;

  t = OSGetCount();
  AUBeep();
  while (!AUDone());
  printf("beep takes %d/10 s\n", (OSGetCount() - t + 50) / 100);
  if (AUPlay("nosuch.wav")) printf("no file\n");
  while (!AUDone());
  for (i = 0; i < 50; i++) LCDLine(10 * i, 200, 10 * i, 200 - AUMicrophone() / 20, GREEN);
  LCDMenu("BEEP", "", "", "END");
  while (KEYGet() != KEY4) { AUBeep(); LCDPrintf("beep\n"); }
}
