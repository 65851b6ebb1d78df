/* Threads of an only robot that wait for what the library is not told of, and clocks and sleeps of
   the C library. */
#define _GNU_SOURCE
#include <poll.h>
#include <sched.h>
#include <sys/select.h>
#include <sys/wait.h>
#include <time.h>

#include "eyebot.h"

static __thread int mine = 0;
static pthread_key_t key;
static pthread_barrier_t barrier;
static int ends[2];

static void* read_all(void* unused) {
  char c;
  (void)unused;
  while (read(ends[0], &c, 1) == 1) mine++;
  pthread_setspecific(key, &mine);
  printf("read %d at %d\n", *(int*)pthread_getspecific(key), OSGetCount());
  return NULL;
}

static void* meet(void* wait) {
  OSWait((int)(long)wait);
  pthread_barrier_wait(&barrier);
  return NULL;
}

static void* leave(void* code) { pthread_exit(code); }

static void* add_one(void* number) { return (void*)((long)number + 1); }

/* The child has no robot, but threads like any process. */
static void forks(void) {
  int status = 0;
  const pid_t child = fork();
  if (child == 0) {
    pthread_t thread;
    void* result = NULL;
    pthread_create(&thread, NULL, add_one, (void*)41L);
    pthread_join(thread, &result);
    _exit((int)(long)result);
  }
  waitpid(child, &status, 0);
  printf("the child's thread says %d\n", WEXITSTATUS(status));
}

static void sleeps(void) {
  struct timeval three_tenths = {0, 300000};
  struct timespec then;
  const int start = OSGetCount();
  select(0, NULL, NULL, NULL, &three_tenths);
  poll(NULL, 0, 200);
  printf("select, poll %d\n", OSGetCount() - start);
  clock_gettime(CLOCK_MONOTONIC, &then);
  then.tv_sec += 2;
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &then, NULL);
  printf("until then %d\n", OSGetCount() - start);
  clock_gettime(CLOCK_REALTIME, &then);
  then.tv_sec += 1;
  clock_nanosleep(CLOCK_REALTIME, TIMER_ABSTIME, &then, NULL);
  printf("until that time of day %d\n", OSGetCount() - start);
  while (clock() < (start + 4000) * (CLOCKS_PER_SEC / 1000)) {
  }
  printf("looked at the clock until %d\n", OSGetCount() - start);
}

int main() {
  pthread_t a, b;
  void* result;
  int i;
  OSGetCount();
  if (pipe(ends) != 0) return 1;
  pthread_key_create(&key, NULL);
  pthread_create(&a, NULL, read_all, NULL);
  for (i = 0; i < 5; i++) {
    OSWait(100);
    if (write(ends[1], "x", 1) != 1) return 1;
  }
  close(ends[1]);
  pthread_join(a, NULL);
  printf("%d of mine at %d\n", mine, OSGetCount());

  pthread_barrier_init(&barrier, NULL, 3);
  pthread_create(&a, NULL, meet, (void*)10L);
  pthread_create(&b, NULL, meet, (void*)30L);
  pthread_barrier_wait(&barrier);
  printf("met at %d\n", OSGetCount());
  pthread_join(a, NULL);
  pthread_join(b, NULL);

  pthread_create(&a, NULL, leave, (void*)5L);
  pthread_join(a, &result);
  sched_yield();
  printf("left %ld at %d\n", (long)result, OSGetCount());
  fflush(stdout);
  forks();
  sleeps();
  return 0;
}
