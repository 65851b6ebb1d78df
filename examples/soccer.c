/* Soccer for one robot or two teams: get behind the ball, push it towards the goal, kick.
   The first half of the robots plays to the right. The last one of a team of three or more keeps
   the goal, the one nearest to the ball goes for it, the others stay behind it.
   Robot 1 is the referee, too: it counts goals, and frees a ball that lies still.
   soccer [SECONDS]: how long to play, 600 s without. */
#include <math.h>
#include <stdlib.h>

#include "eyebot.h"

/* The field of soccer-field.wld, mm. */
#define LEFT 180.0
#define RIGHT 2920.0
#define WIDTH 1520.0
#define MIDDLE (WIDTH / 2)
#define MOUTH 220.0   /* half the width of a goal, less the ball */
#define REACH 130.0   /* from my centre to that of a ball that can be kicked */
#define KICKER 3      /* the servo that kicks */
#define PERIOD 50     /* ms between two decisions */
#define PATIENCE 8000 /* ms that a ball may lie still */
#define MAXROBOTS 64

typedef struct {
  double x, y, phi;
} Place;

static int me, count, first, last; /* my number, and those of my team's first and last */
static double side;                /* 1: we play to the right, -1: to the left */
static Place ball, robot[MAXROBOTS + 1];

static double clamp(double v, double low, double high) {
  return v < low ? low : v > high ? high : v;
}
static double distance(Place a, Place b) { return hypot(a.x - b.x, a.y - b.y); }
static double bearing(Place from, Place to) {
  double angle = atan2(to.y - from.y, to.x - from.x) * 180 / M_PI - from.phi;
  return remainder(angle, 360);
}

static Place place(int x, int y, int phi) {
  Place p = {x, y, phi};
  return p;
}

static void look(void) {
  int i, x, y, z, phi;
  SIMGetObject(1, &x, &y, &z, &phi);
  ball = place(x, y, phi);
  for (i = 1; i <= count; i++) {
    SIMGetRobot(i, &x, &y, &z, &phi);
    robot[i] = place(x, y, phi);
  }
}

/* Steers to `to`; slows down before it unless `through`. */
static void drive_to(Place to, double speed, int through) {
  double error = bearing(robot[me], to), rest = distance(robot[me], to);
  double linear = through ? speed : fmin(speed, 3 * rest);
  if (!through && rest < 15) {
    VWSetSpeed(0, 0);
    return;
  }
  if (fabs(error) > 60) linear = 0;
  VWSetSpeed((int)lrint(linear * cos(error * M_PI / 180)), (int)lrint(clamp(4 * error, -240, 240)));
}

/* Behind the ball as seen from their goal: at it, else round it. */
static void attack(void) {
  Place goal = {side > 0 ? RIGHT + 80 : LEFT - 80, clamp(ball.y, MIDDLE - 120, MIDDLE + 120), 0},
        to;
  double d = distance(ball, goal), gx = (goal.x - ball.x) / d, gy = (goal.y - ball.y) / d;
  double rx = robot[me].x - ball.x, ry = robot[me].y - ball.y;
  double along = rx * gx + ry * gy, across = gx * ry - gy * rx;
  if (along < -50 && fabs(across) < 45) {
    to.x = ball.x + 150 * gx;
    to.y = ball.y + 150 * gy;
    drive_to(to, 450, 1);
    if (distance(robot[me], ball) < REACH && fabs(bearing(robot[me], ball)) < 20 &&
        fabs(bearing(robot[me], goal)) < 12) {
      SERVOSet(KICKER, 255);
      SERVOSet(KICKER, 128);
    }
    return;
  }
  to.x = ball.x - 170 * gx;
  to.y = ball.y - 170 * gy;
  if (along > -90) { /* not through the ball: first past it, on that side of it where I am */
    double way = across < 0 ? -170 : 170;
    to.x = ball.x - 150 * gx - way * gy;
    to.y = ball.y - 150 * gy + way * gx;
  }
  to.x = clamp(to.x, LEFT + 90, RIGHT - 90);
  to.y = clamp(to.y, 90, WIDTH - 90);
  drive_to(to, 500, along > -90);
}

static void keep_goal(void) {
  Place to = {side > 0 ? LEFT + 110 : RIGHT - 110, clamp(ball.y, MIDDLE - MOUTH, MIDDLE + MOUTH),
              0};
  drive_to(to, 400, 0);
}

/* Each at a height of its own between the ball and our goal. */
static void support(void) {
  Place to;
  to.x = clamp(ball.x - side * (350 + 150 * ((me - first) % 3)), LEFT + 350, RIGHT - 350);
  to.y = WIDTH * (me - first + 1) / (last - first + 2.0);
  drive_to(to, 350, 0);
}

static int nearest_of_team(void) {
  int i, best = first, field = last - first >= 2 ? last - 1 : last;
  for (i = first; i <= field; i++)
    if (distance(robot[i], ball) < distance(robot[best], ball)) best = i;
  return best;
}

static void referee(void) {
  static int score[2], since, known;
  static Place lay;
  int now = OSGetCount(), goal = ball.x > RIGHT + 15 ? 1 : ball.x < LEFT - 15 ? 2 : 0;
  if (!known || distance(ball, lay) > 30) {
    known = 1;
    lay = ball;
    since = now;
  }
  if (goal) {
    score[goal - 1]++;
    printf("goal after %d s: %d to %d\n", now / 1000, score[0], score[1]);
    LCDPrintf("%d : %d\n", score[0], score[1]);
  }
  if (goal || now - since > PATIENCE) {
    SIMSetObject(1, (int)((LEFT + RIGHT) / 2), (int)MIDDLE, 0, 0);
    known = 0;
  }
}

int main(int argc, char* argv[]) {
  int i, end = argc > 1 ? 1000 * atoi(argv[1]) : 600000;
  me = OSMachineID();
  count = SIMGetRobotCount();
  if (count > MAXROBOTS || me < 1) return 1;
  side = me <= (count + 1) / 2 ? 1 : -1;
  first = side > 0 ? 1 : (count + 1) / 2 + 1;
  last = side > 0 ? (count + 1) / 2 : count;
  LCDMenu("", "", "", "END");
  while (OSGetCount() < end && KEYRead() != KEY4) {
    look();
    if (me == 1) referee();
    if (VWStalled()) { /* free myself, each to its own side */
      VWSetSpeed(-200, me % 2 ? 60 : -60);
      for (i = 0; i < 6; i++) OSWait(PERIOD);
    }
    if (me == nearest_of_team())
      attack();
    else if (me == last && last - first >= 2)
      keep_goal();
    else
      support();
    OSWait(PERIOD);
  }
  VWSetSpeed(0, 0);
  return 0;
}
