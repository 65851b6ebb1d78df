// One of many robots that use everything at once, each with a thread and a timer of its own. Robot
// 3 ends at once, robot 5 aborts on its way.
#include <eyebridge.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <eyebot.h>

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static int seen;  // by the thread, of the robot's own variables
static BYTE image[QQVGA_SIZE];

static void tick(void) { LCDPixel(10, 10, RED); }

static void* watches(void* unused) {
  (void)unused;
  /* That of robot 5, which never joins it, is there until it aborts. */
  for (int i = 0; i < 20 || OSMachineID() == 5; ++i) {
    int x, y, z, phi;
    SIMGetRobot(i % 8 + 1, &x, &y, &z, &phi);
    if (strlen(EYEBRIDGELastError()) > 0) return NULL;
    LCDSetPrintf(i % 10, 0, "%d %d", PSDGet(PSD_LEFT), KEYRead());
    pthread_mutex_lock(&mutex);
    ++seen;
    pthread_cond_signal(&changed);
    pthread_mutex_unlock(&mutex);
    OSWait(5);
  }
  return NULL;
}

static void drives(int id) {
  static int scan[360];
  char text[40];
  int x, y, phi, from;
  for (int i = 0; i < 20; ++i) {
    VWSetSpeed(100, i % 2 ? 60 : -60);
    VWGetPosition(&x, &y, &phi);
    snprintf(text, sizeof text, "%d at %d %d", id, x, y);
    RADIOSend(i % 8 + 1, text);
    if (RADIOCheck() > 0) RADIOReceive(&from, text, sizeof text);
    LCDPrintf("%d\n", PSDGet(PSD_FRONT));
    if (i % 5 == 0) LIDARGet(scan);
    if (i == 10) SIMSetObject(1, 200 + 70 * id, 2700, 0, 0);
    if (i == 12 && id == 5) abort();
    OSWait(5);
  }
}

int main(void) {
  const int id = OSMachineID();
  if (id == 3) return 0;
  RADIOInit();
  const TIMER timer = OSAttachTimer(10, tick);
  pthread_t watcher;
  pthread_create(&watcher, NULL, watches, NULL);
  drives(id);
  if (id % 16 == 1 && CAMInit(QQVGA) == 0) LCDImage((CAMGet(image), image));
  pthread_mutex_lock(&mutex);
  while (seen < 20) pthread_cond_wait(&changed, &mutex);
  pthread_mutex_unlock(&mutex);
  pthread_join(watcher, NULL);
  OSDetachTimer(timer);
  printf("robot %d saw %d, %s\n", id, seen, strlen(EYEBRIDGELastError()) == 0 ? "well" : "failing");
  return 0;
}
