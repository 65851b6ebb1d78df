/* A screen, keys and touches for a person at a terminal; ends in the way that the environment says.
 */
#include "eyebot.h"

static int overflow(int depth) {
  volatile char room[4096];
  room[depth % 4096] = 1;
  return depth < 0 ? 0 : overflow(depth + 1) + room[0];
}

int main() {
  const char* how = getenv("EYEBRIDGE_TEST_HOW");
  int key, x, y;

  printf("asks: ");
  fflush(stdout);
  LCDSetPrintf(0, 0, "Hello");
  LCDSetColor(RED, WHITE);
  LCDSetPrintf(2, 5, "red");
  LCDArea(70, 150, 139, 209, BLUE, 1);
  LCDMenu("GO", "TOUCH", "", "END");
  do {
    key = KEYGet();
    printf("key %d\n", key);
    fprintf(stderr, "told %d\n", key);
    LCDSetPrintf(4, 0, "key %d", key);
    if (key == KEY2 && KEYGetXY(&x, &y) == 0) printf("touch %d %d\n", x, y);
  } while (key != KEY4);
  if (how == NULL) return 0;
  if (strcmp(how, "exit") == 0) exit(3);
  if (strcmp(how, "_exit") == 0) _exit(4);
  if (strcmp(how, "abort") == 0) abort();
  if (strcmp(how, "fault") == 0) *(volatile int*)strtol("64", NULL, 10) = 1;
  if (strcmp(how, "overflow") == 0) return overflow(0);
  if (strcmp(how, "wait") == 0) pause();
}
