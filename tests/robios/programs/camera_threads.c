/* A thread with the camera outlives main; the renderer's own threads must not keep the process. */
#include "eyebot.h"

static BYTE image[QQVGA_SIZE];

static void* look(void* unused) {
  (void)unused;
  printf("frame %d\n", CAMGet(image));
  return NULL;
}

int main() {
  pthread_t thread;
  CAMInit(QQVGA);
  pthread_create(&thread, NULL, look, NULL);
  pthread_exit(0);
}
