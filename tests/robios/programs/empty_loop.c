/* Ends in an endless loop without a call, as many students' programs do. */
#include <eyebot.h>

int main(void) {
  LCDPrintf("done\n");
  for (;;) {
  }
}
