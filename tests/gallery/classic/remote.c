/* TV remote control, and sounds */
#include "eyebot.h"
#include "irtv.h"

BYTE sample[3000];

int main ()
{ int code, bits[2], count, duration, id, clock, t;

  printf("init %d\n", IRTVInitHDT(IRTV));
  IRTVFlush();
  printf("pressed %d\n", IRTVPressed());
  code = IRTVGet();
  printf("first %c\n", code);
  OSWait(200);
  printf("second %c, ", IRTVRead());
  printf("then %d\n", IRTVRead());
  IRTVGetRaw(bits,&count,&duration,&id,&clock);
  printf("decoded %s\n", IRTVDecodeRaw(bits,count,SPACE_CODE) >= 0 ? "something" : "nothing");
  IRTVTerm();
  printf("by hand %d\n", IRTVInit(SPACE_CODE,15,0,0,DEFAULT_MODE,1,-1));
  IRTVTerm();

  t = OSGetCount();
  AURecordSample(sample,3000,8192);
  while (!AUCheckRecord()) OSWait(1);
  printf("recorded %s\n", OSGetCount() - t > 10 ? "a while" : "nothing");
  AUPlaySample(sample);
  while (!AUCheckSample()) OSWait(1);
  printf("microphone %d\n", AUCaptureMic() / 100);
  LCDPrintf("%c",code);
  return 0;
}
