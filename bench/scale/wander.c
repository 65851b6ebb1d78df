// The controller that all peers were measured with, as a program of a user writes it: wander
// SECONDS. Eight PSDGet() a decision, ten decisions a second; `./test peers` runs many of it.
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <eyebot.h>

enum { kSensors = 8, kTick_ms = 100, kNear_mm = 500, kNothing_mm = 4000 };

static uint32_t state;

/// Numerical Recipes' generator, as in the peers' controllers.
static uint32_t draw(void) {
  state = state * 1664525U + 1013904223U;
  return state >> 16;
}

static int nearest(const int* ranges, int first, int last) {
  int range = kNothing_mm;
  for (int i = first; i <= last; ++i) {
    if (ranges[i % kSensors] < range) range = ranges[i % kSensors];
  }
  return range;
}

// What was done, for a comparison with others.
static double range_m, distance_m;
static long rays, hits;

static void count(const int* ranges) {
  static int x, y;
  int now_x, now_y, z, phi;
  SIMGetRobot(OSMachineID(), &now_x, &now_y, &z, &phi);
  if (rays > 0) distance_m += hypot(now_x - x, now_y - y) * 1e-3;
  x = now_x;
  y = now_y;
  for (int i = 0; i < kSensors; ++i) {
    const int range = ranges[i] < kNothing_mm ? ranges[i] : kNothing_mm;
    range_m += range * 1e-3;
    hits += range < 0.999 * kNothing_mm;
  }
  rays += kSensors;
}

int main(int argc, char** argv) {
  const int ticks = 10 * (argc > 1 ? atoi(argv[1]) : 60);
  int turning = 0;
  int side = 1;
  state = (uint32_t)OSMachineID() * 2654435761U + 12345U;
  const int start = OSGetCount();
  for (int tick = 1; tick <= ticks; ++tick) {
    int ranges[kSensors];  // counter-clockwise from straight ahead
    for (int i = 0; i < kSensors; ++i) ranges[i] = PSDGet(i + 1);
    count(ranges);
    if (turning > 0) {
      --turning;
    } else if (nearest(ranges, 7, 9) < kNear_mm) {
      side = nearest(ranges, 1, 2) < nearest(ranges, 6, 7) ? -1 : 1;
      turning = 5 + (int)(draw() % 10);
      VWSetSpeed(0, 57 * side);
    } else {
      VWSetSpeed(300, 0);
    }
    OSWait(start + tick * kTick_ms - OSGetCount());
  }
  printf("rays=%ld range_m=%.3f hits=%ld distance_m=%.3f\n", rays, range_m, hits, distance_m);
  return 0;
}
