/* Serial lines, radio, remote control and sound. */
#include "eyebot.h"
#include "tell.h"

static void radio() {
  BYTE id, buf[MAXMSGLEN];
  int len, i;
  RadioIOParameters io;
  RadioStatus status;

  TELL("off", RADIOSend(2, 5, "hello"));
  TELL("radio", RADIOInit());
  RADIOGetIoctl(&io);
  RADIOSetIoctl(&io);
  TELL("id", io.id);
  TELL("send", RADIOSend(io.id, 5, "hello"));
  TELL("to all", RADIOSend(BROADCAST, 2, "hi"));
  TELL("to the host", RADIOSend(0, 1, "h"));
  TELL("too long", RADIOSend(1, MAXMSGLEN + 1, buf));
  for (i = 0; i < 100 && !RADIOCheck(); i++) OSWait(1);
  TELL("waiting", RADIOCheck());
  RADIORecv(&id, &len, buf);
  printf("got %d bytes from %d: %.5s\n", len, id, (char*)buf);
  TELL("status", RADIOGetStatus(&status));
  TELL("there", status.active[io.id]);
  TELL("null", RADIOGetStatus(NULL));
  TELL("term", RADIOTerm());
}

static void remote() {
  int key;
  TELL("early", IRTVRead());
  TELL("remote", IRTVInitHDT(IRTV));
  TELL("bad type", IRTVInit(9, 0, 0, 0, 0, 1, 0));
  key = IRTVGet();
  TELL("code", key);
  OSWait(200);
  TELL("pressed", IRTVPressed());
  TELL("read", IRTVRead());
  TELL("none", IRTVRead());
  IRTVFlush();
  IRTVTerm();
}

static void sound() {
  int i;
  BYTE buf[100] = {0};
  TELL("too low", AUTone(10, 10));
  TELL("null", AUPlaySample(NULL));
  TELL("no sample", AUPlaySample(buf));
  TELL("tone", AUTone(1000, 200));
  for (i = 0; !AUCheckTone(); i++) OSWait(1);
  TELL("took", i >= 19 && i <= 21);
  AUBeep();
  TELL("record", AURecordSample(buf, 100, 8000));
  TELL("recorded", AUCheckRecord());
  TELL("sample", AUCheckSample() == AUCheckTone());
}

int main() {
  char c;
  TELL("no line", OSInitRS232(SER9600, NONE, SERIAL3));
  TELL("no line", OSSendCharRS232('x', SERIAL3));
  TELL("no line", OSRecvRS232(&c, 0));
  TELL("no line", OSCheckInRS232(SERIAL3));
  TELL("null", OSSendRS232(NULL, SERIAL1));
  radio();
  remote();
  sound();
  return 0;
}
