/* Follows the outer wall of a corridor on its right, round two corners, and stops before the third.
 * It believes none of its sensors at once: a line to a board may lose bytes, or change them. */
#include "eyebot.h"

#define KEEP_MM 240
#define SPEED_MM_S 200
#define STEER_DEG_S 25
#define CORNER_MM 280
#define ASKEW_DEG 20
#define PERIOD_MS 50

static int psd(int which) { return PSDGet(which); }

static int heading(int unused) {
  int x, y, phi;

  (void)unused;
  return VWGetPosition(&x, &y, &phi) == 0 ? phi + 360 : -1;
}

/* The middle one of three readings that came. */
static int middle(int (*read)(int), int which) {
  int r[3];
  int i;

  for (i = 0; i < 3; i++) {
    while ((r[i] = read(which)) < 0) OSWait(10);
  }
  if ((r[0] <= r[1]) == (r[1] <= r[2])) return r[1];
  if ((r[1] <= r[0]) == (r[0] <= r[2])) return r[0];
  return r[2];
}

/* Two of three readings are wrong once in some thousand times. A corner that is not there ends the
 * course too early, so the wall must be seen twice. */
static int wall_ahead(void) {
  return middle(psd, PSD_FRONT) < CORNER_MM && middle(psd, PSD_FRONT) < CORNER_MM;
}

/* Degrees from where the robot looks to `direction`, -180 ... 179. */
static int askew(int direction) { return (direction - middle(heading, 0) + 900) % 360 - 180; }

/* Turns there; again when the line has swallowed a part of it. */
static void face(int direction) {
  int rest;

  for (rest = askew(direction); rest < -2 || rest > 2; rest = askew(direction)) {
    VWTurn(rest, 90);
    VWWait();
    OSWait(200);
  }
}

int main() {
  int corners = 0;
  int last = middle(psd, PSD_RIGHT);

  setvbuf(stdout, NULL, _IOLBF, 0);
  printf("following\n");
  for (;;) {
    int ahead = wall_ahead();
    int off = askew(90 * corners);
    int right, steer;

    if (ahead || off > ASKEW_DEG || off < -ASKEW_DEG) {
      VWSetSpeed(0, 0);
      if (off <= ASKEW_DEG && off >= -ASKEW_DEG && ++corners == 3) break;
      face(90 * corners);
      last = middle(psd, PSD_RIGHT);
    }
    right = middle(psd, PSD_RIGHT);
    steer = (KEEP_MM - right) / 4 + 2 * (last - right);
    if (steer > STEER_DEG_S) steer = STEER_DEG_S;
    if (steer < -STEER_DEG_S) steer = -STEER_DEG_S;
    VWSetSpeed(SPEED_MM_S, steer);
    last = right;
    OSWait(PERIOD_MS);
  }
  OSWait(500);
  printf("three corners after %d ms\n", OSGetCount());
  return 0;
}
