/* AU in virtual time: nothing is heard, but a sound takes its time. argv[1]: a sound file. */
#include "eyebot.h"

int main(int argc, char** argv) {
  int before;

  (void)argc;
  printf("done at first %d\n", AUDone());
  printf("beep %d", AUBeep());
  before = OSGetCount();
  printf(" %d\n", AUDone());
  while (!AUDone()) OSWait(1);
  printf("beeped %d\n", (OSGetCount() - before + 5) / 10 * 10);
  printf("play %d\n", AUPlay(argv[1]));
  before = OSGetCount();
  while (!AUDone()) OSWait(1);
  printf("played %d\n", (OSGetCount() - before + 5) / 10 * 10);
  printf("bad %d %d\n", AUPlay("no-such-file.wav"), AUPlay(NULL));
  return 0;
}
