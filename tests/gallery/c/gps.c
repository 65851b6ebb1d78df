// reads a GPS on USB 1 - if there is one
#include "eyebot.h"

int main()
{
  char line[100], c;
  int n = 0, x;

  if (SERInit(1, 4800, NONE) != 0)
  {
    LCDPrintf("no GPS on USB\n");
    printf("no GPS\n");
    x = SERSend(1, "$PMTK\r\n");
    printf("send anyway: %s\n", x ? "failed" : "sent");
    SERSendChar(1, '\n');
    x = SERReceive(1, line, 100);
    printf("waiting: %d, got %d\n", SERCheck(1), x);
    SERFlush(1);
    c = SERReceiveChar(1);
    printf("char %d, close %d\n", c, SERClose(1) != 0);
    return 1;
  }
  while (n < 99 && (c = SERReceiveChar(1)) != '\n') line[n++] = c;
  line[n] = 0;
  LCDPrintf("%s\n", line);
  SERClose(1);
  return 0;
}
