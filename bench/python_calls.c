/* What calls cost in C, for bench/python_calls.py: one line each, "NAME NANOSECONDS". */
#include "eyebot.h"

#define CALLS 200000
#define REPEATS 7

static double now_ns(void) {
  struct timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return (double)time.tv_sec * 1e9 + (double)time.tv_nsec;
}

/* The fastest of several rounds: what disturbs can only add. */
#define MEASURE(name, call)                            \
  do {                                                 \
    double best = 1e18;                                \
    for (int repeat = 0; repeat < REPEATS; ++repeat) { \
      const double start = now_ns();                   \
      for (int i = 0; i < CALLS; ++i) (void)(call);    \
      const double ns = (now_ns() - start) / CALLS;    \
      if (ns < best) best = ns;                        \
    }                                                  \
    printf("%s %.1f\n", name, best);                   \
  } while (0)

int main(void) {
  int x, y, phi;
  MEASURE("IPPRGB2Col", IPPRGB2Col(1, 2, 3));
  MEASURE("PSDGet", PSDGet(PSD_FRONT));
  MEASURE("KEYRead", KEYRead());
  MEASURE("VWGetPosition", VWGetPosition(&x, &y, &phi));
  MEASURE("VWSetSpeed", VWSetSpeed(0, 0));
  MEASURE("LCDPixel", LCDPixel(1, 2, RED));
  MEASURE("LCDSetPrintf", LCDSetPrintf(0, 0, "PSD %5d", 123));
  return 0;
}
