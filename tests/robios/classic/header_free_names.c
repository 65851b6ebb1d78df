/* Names that real programs define for themselves, after the header; and C99 without extensions. */
#include <eyebot.h>

#define LEFT 1
#define RIGHT 2
#define FRONT 3
#define BACK 4
#define SPEED 0.1
#define SIZE 10
#define PI 3.14
#define STOP 0
#define DEBUG 1
#define SLAVES 3
#define DIST 0.4
#define MAXLEN 20
#define NO_HUE (-1)

static int x = 1, y = 1, y1 = 1, j0 = 1, index = 1, phi = 1, speed = 1, push = 1, map = 1, img = 1;
static int next = 1, path = 1, step = 1, stop = 1, scan = 1, wall = 1, vw = 1, name = 1;
static int min(int a, int b) { return a < b ? a : b; }
static int drive(void) { return 1; }

int classic_names_in_use(void);
int classic_names_in_use(void) {
  return x + y + y1 + j0 + index + phi + speed + push + map + img + next + path + step + stop +
         scan + wall + vw + name + min(1, 2) + drive();
}

/* Declared as old programs do; sizes as the manuals have them. */
image grey;
colimage colour;
PositionType position;
struct sem semaphore;
struct tcb* task;
tone melody[] = {{440, 200}, {0, 0}};
int classic_sizes(void);
int classic_sizes(void) {
  return sizeof grey == 5084 && sizeof colour == 15252 && sizeof melody == 16 && sizeof(BYTE) == 1;
}
