/* Serial lines, radio, remote control and sound, where there may be none. */
#include "eyebot.h"

int main()
{ char c;
  BYTE id, buf[MAXMSGLEN];
  int len, i, key[2];
  RadioIOParameters io;
  RadioStatus status;

  printf("serial %d %d %d %d %d\n", OSInitRS232(SER9600, NONE, SERIAL3), OSInitRS232(99, NONE, 7),
         OSSendCharRS232('x', SERIAL3), OSRecvRS232(&c, 0), OSCheckInRS232(SERIAL3) < 0);
  printf("off %d\n", RADIOSend(2, 5, "hello"));
  printf("radio %d\n", RADIOInit());
  RADIOGetIoctl(&io);
  RADIOSetIoctl(&io);
  printf("id %d, send %d %d %d %d\n", io.id, RADIOSend(io.id, 5, "hello"),
         RADIOSend(BROADCAST, 2, "hi"), RADIOSend(0, 1, "h"), RADIOSend(1, MAXMSGLEN + 1, buf));
  for (i = 0; i < 100 && !RADIOCheck(); i++) OSWait(1);
  printf("waiting %d\n", RADIOCheck());
  RADIORecv(&id, &len, buf);
  printf("got %d bytes from %d: %.5s\n", len, id, (char*)buf);
  printf("status %d: %d is there\n", RADIOGetStatus(&status), status.active[io.id]);
  printf("term %d\n", RADIOTerm());
  printf("remote %d %d\n", IRTVInitHDT(IRTV), IRTVInit(9, 0, 0, 0, 0, 1, 0));
  key[0] = IRTVGet();
  key[1] = IRTVRead();
  printf("codes %d, pressed %d\n", key[0] > 0, key[1] + IRTVPressed());
  IRTVFlush();
  IRTVTerm();
  printf("sound %d %d %d\n", AUTone(10, 10), AUPlaySample(NULL), AUCheckRecord());
  AUTone(1000, 200);
  for (i = 0; !AUCheckTone(); i++) OSWait(1);
  AUBeep();
  printf("tone took %d\n", i);
  printf("record %d\n", AURecordSample(buf, 10, 8000));
  return 0;
}
