// The first robot's thread and its main program wait for each other; the second robot goes on.
#include <pthread.h>
#include <stdio.h>

#include <eyebot.h>

static pthread_mutex_t first = PTHREAD_MUTEX_INITIALIZER;
static pthread_mutex_t second = PTHREAD_MUTEX_INITIALIZER;

static void* other(void* unused) {
  pthread_mutex_lock(&second);
  OSWait(100);
  pthread_mutex_lock(&first);
  return unused;
}

int main(void) {
  if (OSMachineID() == 1) {
    pthread_t thread;
    pthread_mutex_lock(&first);
    pthread_create(&thread, NULL, other, NULL);
    OSWait(100);
    pthread_mutex_lock(&second);
  }
  OSWait(1000);
  printf("robot %d is done\n", OSMachineID());
  return 0;
}
