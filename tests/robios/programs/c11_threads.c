/* Threads of C11, without a call before theirs. */
#define _GNU_SOURCE
#include <stdio.h>
#include <threads.h>
#include <time.h>

#include "eyebot.h"

static mtx_t mutex;
static cnd_t changed;
static tss_t own;
static int turn = 0;

static int run(void* given) {
  const int me = *(int*)given;
  tss_set(own, given);
  for (int i = 0; i < 10; ++i) {
    const struct timespec pause = {0, 10000000};
    thrd_sleep(&pause, NULL);
  }
  mtx_lock(&mutex);
  while (turn != me) cnd_wait(&changed, &mutex);
  ++turn;
  cnd_broadcast(&changed);
  mtx_unlock(&mutex);
  return OSGetCount() + *(int*)tss_get(own);
}

int main() {
  static int numbers[] = {1, 0, 2};
  thrd_t threads[3];
  int results[3];
  struct timespec until;
  mtx_init(&mutex, mtx_timed);
  cnd_init(&changed);
  tss_create(&own, NULL);
  for (int i = 0; i < 3; ++i) thrd_create(&threads[i], run, &numbers[i]);
  for (int i = 0; i < 3; ++i) thrd_join(threads[i], &results[i]);
  timespec_get(&until, TIME_UTC);
  const long seconds = until.tv_sec;
  until.tv_sec += 2;
  mtx_lock(&mutex);
  const int late = cnd_timedwait(&changed, &mutex, &until) == thrd_timedout;
  mtx_unlock(&mutex);
  printf("%d: %d %d %d, %ld, late %d at %d\n", OSMachineID(), results[0], results[1], results[2],
         seconds, late, OSGetCount());
}
