// Names that real programs define for themselves, after the header.
#include <eyebot.h>

#define LEFT 1
#define RIGHT 2
#define FRONT 3
#define BACK 4
#define SPEED 100
#define SIZE 10
#define MAX 5
#define MIN 6
#define PI 3.14
#define X 1
#define Y 2
#define SAFE 200
#define STOP 0
#define DEBUG 1
#define RESET 2
#define SCALE 3
#define DIST 4
#define STEP 5
#define LCD_WIDTH 320
#define LCD_HEIGHT 240
#define MAX_NODES 10
#define LINE_MAX 80
#define TIMEOUT 5

enum { NONE = 3, RTSCTS = 4 };

static const int PSD_DOWN = 6;

static int x = 1, y = 1, phi = 1, i = 1, t = 1, speed = 1, distance = 1, push = 1, map = 1;
static int image = 1, img = 1, nodes = 1, next = 1, pool = 1, path = 1, points = 1, step = 1;
static int stop = 1, scan = 1, mark = 1, wall = 1, width = 1, vector = 1, error = 1, pi = 1;
static int update(void) { return 1; }
static int drive(void) { return 1; }
static int straight(void) { return 1; }
static int turn_left(void) { return 1; }

int free_names_in_use(void);
int free_names_in_use(void) {
  return x + y + phi + i + t + speed + distance + push + map + image + img + nodes + next + pool +
         path + points + step + stop + scan + mark + wall + width + vector + error + pi + update() +
         drive() + straight() + turn_left() + PSD_DOWN + NONE + RTSCTS;
}
