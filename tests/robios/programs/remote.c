/* Codes of a remote control, from the key script. */
#include "eyebot.h"

int main() {
  int code;

  printf("status %d none %d\n", IRTVGetStatus(), IRTVRead());
  code = IRTVGet();
  printf("got %c at %d\n", code, OSGetCount() / 1000);
  OSWait(2000);
  printf("read %d", IRTVRead() == IRTV_RIGHT);
  printf(" %d", IRTVRead() == IRTV_POWER);
  printf(" %d\n", IRTVRead());
  OSWait(2000);
  printf("flush %d", IRTVFlush());
  printf(" %d\n", IRTVRead());
  printf("key %d\n", KEYWait(KEY2));
  IRTVGet(); /* none can come any more */
  printf("never\n");
  return 0;
}
