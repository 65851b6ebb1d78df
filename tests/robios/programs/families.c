/* Threads of a program, each with families of its own: LCD, driving, sensors, lines, radio. */
#include "eyebot.h"

static void* shows(void* unused) {
  int i, x, y;
  (void)unused;
  for (i = 0; i < 200; i++) {
    LCDSetPrintf(i % 10, 0, "line %d", i);
    LCDLine(0, i, 100, 200 - i, RED);
    LCDAreaInvert(10, 10, 20, 20);
    LCDGetPos(&x, &y);
  }
  return NULL;
}

static void* drives(void* unused) {
  int i, x, y, phi;
  (void)unused;
  for (i = 0; i < 50; i++) {
    VWStraight(10, 100);
    VWGetPosition(&x, &y, &phi);
  }
  VWWait();
  return NULL;
}

static void* senses(void* unused) {
  static int scan[360];
  int i;
  (void)unused;
  for (i = 0; i < 100; i++) {
    PSDGet(PSD_FRONT);
    if (i % 10 == 0) LIDARGet(scan);
    DIGITALWrite(9 + i % 8, i % 2);
    ANALOGRead(i % 9);
    KEYRead();
    IRTVRead();
  }
  return NULL;
}

static void* talks(void* unused) {
  char text[20];
  int i, id, heard = 0;
  (void)unused;
  for (i = 0; i < 100; i++) {
    RADIOSend(RADIOGetID(), "me");
    if (RADIOCheck() > 0) heard += RADIOReceive(&id, text, sizeof text) == 2;
  }
  printf("heard %d\n", heard);
  return NULL;
}

int main() {
  void* (*const work[4])(void*) = {shows, drives, senses, talks};
  pthread_t thread[4];
  int i;

  RADIOInit();
  for (i = 0; i < 4; i++) pthread_create(&thread[i], NULL, work[i], NULL);
  for (i = 0; i < 4; i++) pthread_join(thread[i], NULL);
  printf("all done\n");
  return 0;
}
