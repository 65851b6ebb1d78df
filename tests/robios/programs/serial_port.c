/* SER, in the forms that programs use. At the other end somebody answers "<" + text + ">". */
#include "eyebot.h"

int main() {
  char text[100];
  int n;

  printf("closed %d %d\n", SERSend(1, "x"), SERCheck(1));
  printf("init %d\n", SERInit(1, 115200, NONE));
  printf("send %d", SERSend(1, "one"));
  printf(" %d", SERSendChar(1, '.'));
  printf(" %d\n", SERSend(1, "a\0b", 3));
  for (n = 0; n < 11; n++) text[n] = SERReceiveChar(1);
  printf("received");
  for (n = 0; n < 11; n++) printf(" %02X", (unsigned)text[n]);
  printf("\n");
  SERSend(1, "two");
  while (!SERCheck(1)) usleep(1000);
  for (n = 0; n < 5;) n += SERReceive(1, text + n, (int)sizeof text - n);
  printf("then %s\n", text);
  printf("none %d flush %d\n", SERReceive(1, text, 10), SERFlush(1));
  printf("bad %d %d %d %d\n", SERSend(1, NULL), SERReceive(1, NULL, 5), SERReceive(1, text, 0),
         SERSend(1, "x", -1));
  printf("bad init %d %d %d\n", SERInit(7, 9600, 0), SERInit(1, 10, RTSCTS), SERInit(1, 9600, 5));
  printf("close %d", SERClose(1));
  printf(", char %d\n", SERReceiveChar(1));
  return 0;
}
