/* Waits that have an end, and such that only a timer's function ends, or nobody. */
#define _GNU_SOURCE
#include <errno.h>
#include <limits.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <stdio.h>
#include <sys/epoll.h>
#include <sys/select.h>
#include <time.h>
#include <unistd.h>

#include "eyebot.h"

static sem_t given;

static void give(void) { sem_post(&given); }

static void* sleep_second(void* unused) {
  OSWait(1000);
  return unused;
}

static int tens(void) { return OSGetCount() / 10 * 10; }

int main() {
  const struct timespec tenth = {0, 100000000};
  int ends[2];
  pipe(ends);
  OSGetCount();

  struct pollfd file = {ends[0], POLLIN, 0};
  printf("ppoll %d", ppoll(&file, 1, &tenth, NULL));
  fd_set files;
  FD_ZERO(&files);
  FD_SET(ends[0], &files);
  printf(", pselect %d", pselect(ends[0] + 1, &files, NULL, NULL, &tenth, NULL));
  const int set = epoll_create1(0);
  struct epoll_event event = {EPOLLIN, {0}};
  epoll_ctl(set, EPOLL_CTL_ADD, ends[0], &event);
  printf(", epoll_wait %d", epoll_wait(set, &event, 1, 100));
  printf(" at %d\n", tens());

  /* A lone thread: nobody but the timer goes on. */
  sem_init(&given, 0, 0);
  const TIMER timer = OSAttachTimer(50, give);
  for (int i = 0; i < 4; ++i) sem_wait(&given);
  OSDetachTimer(timer);
  printf("given at %d\n", tens());

  pthread_t thread;
  struct timespec until;
  pthread_create(&thread, NULL, sleep_second, NULL);
  clock_gettime(CLOCK_REALTIME, &until);
  until.tv_sec += 1;
  until.tv_nsec = 0;
  const int early = pthread_timedjoin_np(thread, NULL, &until);
  const int early_at = tens();
  clock_gettime(CLOCK_MONOTONIC, &until);
  until.tv_sec += 5;
  const int late = pthread_clockjoin_np(thread, NULL, CLOCK_MONOTONIC, &until);
  printf("joined %d at %d, %d at %d\n", early == ETIMEDOUT, early_at, late, tens());

  const struct timespec never = {LONG_MAX, 0};
  const struct timespec wrong = {0, 1000000000};
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
  pthread_mutex_lock(&mutex);
  printf("wrong %d %d", pthread_cond_timedwait(&changed, &mutex, &wrong) == EINVAL,
         sem_timedwait(&given, &wrong) == -1 && errno == EINVAL);
  printf(" at %d\n", tens());
  fflush(stdout);
  pthread_cond_timedwait(&changed, &mutex, &never);
  printf("never\n");
}
