/* The names that real programs give their own things, all of them, as symbols that the linker sees.
   The second part: names of functions that libraries below ours call. */
#include "eyebot.h"

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
#define LINE_MAX 80

int x, y, phi, i, t, speed, distance, image[QVGA_SIZE], img, nodes, next, pool, path, points, width,
    vector, pi;
const int PSD_DOWN = 6;
int called;
void push(void) { called++; }
void map(void) { called++; }
void update(void) { called++; }
void drive(void) { called++; }
void straight(void) { called++; }
void turn_left(void) { called++; }
void error(void) { called++; }
void step(void) { called++; }
void stop(void) { called++; }
void scan(void) { called++; }
void mark(void) { called++; }
void wall(void) { called++; }

int wrong;
void open(void) { wrong++; }
void poll(void) { wrong++; }
void wait(void) { wrong++; }
void ioctl(void) { wrong++; }
void compress(void) { wrong++; }
void deflate(void) { wrong++; }
void inflate(void) { wrong++; }
void crc32(void) { wrong++; }
void fill(void) { wrong++; }
void guarded(void) { wrong++; }
void session(void) { wrong++; }
int log_level = 1, config, canvas, lcd, keys, fcntl, mkdir;

int main() {
  push();
  map();
  update();
  drive();
  straight();
  turn_left();
  error();
  step();
  stop();
  scan();
  mark();
  wall();
  XInitThreads();
  LCDMenu("GO", "", "", "END");
  LCDPrintf("%d names\n", called);
  CAMInit(QVGA);
  CAMGet((BYTE*)image);
  LCDImage((BYTE*)image);
  PSDGet(PSD_FRONT);
  VWStraight(DIST * SIZE, SPEED);
  VWWait();
  VWGetPosition(&x, &y, &phi);
  KEYRead();
  printf("%d called, %d wrongly, at %d\n", called, wrong, x);
  return 0;
}
