/* Codes of a remote control, from the key script. */
#include "eyebot.h"

int main() {
  int code;

  printf("status %d none %d\n", IRTVGetStatus(), IRTVRead());
  code = IRTVGet();
  printf("got %c at %d\n", code, OSGetCount() / 1000);
  OSWait(2000);
  printf("read %d %d %d\n", IRTVRead() == IRTV_RIGHT, IRTVRead() == IRTV_POWER, IRTVRead());
  OSWait(2000);
  printf("flush %d %d\n", IRTVFlush(), IRTVRead());
  printf("key %d\n", KEYWait(KEY2));
  IRTVGet(); /* none can come any more */
  printf("never\n");
  return 0;
}
