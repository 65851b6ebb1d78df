#include "eyebot.h"

int main()
{
  char buf[100], *text;
  int hrs, mins, secs, ticks;

  if (OSVersion(buf) == 0)     { LCDPrintf("RoBIOS %s\n", buf);  printf("RoBIOS %s\n", buf); }
  if (OSVersionIO(buf) == 0)   LCDPrintf("IO board %s\n", buf);
  else                         LCDPrintf("no IO board\n");
  if (OSMachineName(buf) == 0) { LCDPrintf("name %s\n", buf); printf("name %s\n", buf); }
  LCDPrintf("%d MHz\n", OSMachineSpeed() / 1000000);
  switch (OSMachineType())
  { case VEHICLE:  LCDPrintf("vehicle\n"); break;
    case PLATFORM: LCDPrintf("platform\n"); break;
    case WALKER:   LCDPrintf("walker\n"); break;
    default:       LCDPrintf("no idea\n");
  }
  LCDPrintf("id %d\n", OSMachineID());
  text = OSExecute("echo shell says hi; ls *.txt 2>/dev/null | wc -l");
  LCDPrintf("%s", text);
  printf("%s", text);
  OSSetTime(9, 59, 0);
  OSWait(61500);
  OSGetTime(&hrs, &mins, &secs, &ticks);
  LCDPrintf("%02d:%02d:%02d\n", hrs, mins, secs);
  printf("%d:%02d:%02d, count %d\n", hrs, mins, secs, OSGetCount() / 100);
}
