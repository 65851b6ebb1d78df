/* Threads that use the display, the drive and the sensors at once; main leaves by pthread_exit. */
#include "eyebot.h"

static void* print_much(void* id) {
  int i;
  for (i = 0; i < 200; i++) LCDSetPrintf((int)(long)id, 0, "thread %d line %d", (int)(long)id, i);
  return NULL;
}

static void* drive_about(void* unused) {
  int i;
  (void)unused;
  for (i = 0; i < 50; i++) {
    VWSetSpeed(50, (i % 2) ? 30 : -30);
    PSDGet(PSD_FRONT);
  }
  VWSetSpeed(0, 0);
  printf("drove\n");
  return NULL;
}

int main() {
  pthread_t a, b, c;
  pthread_create(&a, NULL, print_much, (void*)1);
  pthread_create(&b, NULL, print_much, (void*)2);
  pthread_create(&c, NULL, drive_about, NULL);
  pthread_exit(0);
}
