/* Genetic algorithm: four weights steer the robot through the corridor,
   fitness is how far it comes in 8 s without touching anything */
#include "eyebot.h"
#define POP 6
#define GENES 4
#define GENERATIONS 4

float pool[POP][GENES], next[POP][GENES], fit[POP];

float rnd(float lo, float hi) { return lo + (hi - lo) * rand() / (float)RAND_MAX; }

int cut(int v, int m) { return v > m ? m : v; }

float evaluate(float *g)
{
  int t, l, r, f, w, x, y, phi, ox, oy;
  float way = 0;
  SIMSetRobot(0, 300, 300, 0, 0);
  VWSetPosition(0, 0, 0);
  ox = oy = 0;
  for (t = 0; t < 160; t++)
  {
    l = cut(PSDGet(PSD_LEFT), 500); r = cut(PSDGet(PSD_RIGHT), 500); f = PSDGet(PSD_FRONT);
    w = g[0] * (l - r) / 10 + (f < 400 ? g[1] * (400 - f) / 10 : 0);
    if (w > 100) w = 100;
    if (w < -100) w = -100;
    VWSetSpeed(f < 150 ? 60 * g[2] : 250 * g[3], w);
    OSWait(45);
    VWGetPosition(&x, &y, &phi);
    way += sqrt((x - ox) * (x - ox) + (y - oy) * (y - oy));
    ox = x; oy = y;
    if (f < 25 || l < 40 || r < 40) break;        // crash is near
  }
  VWSetSpeed(0, 0);
  return way;
}

int main()
{
  int g, i, j, best = 0;
  srand(7);
  for (i = 0; i < POP; i++) for (j = 0; j < GENES; j++) pool[i][j] = rnd(j < 2 ? -2 : 0.2, j < 2 ? 2 : 1);
  LCDMenu("", "", "", "END");
  for (g = 0; g < GENERATIONS; g++)
  {
    for (i = 0, best = 0; i < POP; i++)
    {
      fit[i] = evaluate(pool[i]);
      LCDLine(20 + 20 * (g * POP + i), 300, 20 + 20 * (g * POP + i), 300 - (int)fit[i] / 10, GREEN);
      if (fit[i] > fit[best]) best = i;
    }
    LCDSetPrintf(g, 0, "generation %d: best %4.0f mm", g, fit[best]);
    printf("generation %d: best %.0f\n", g, fit[best]);
    for (i = 0; i < POP; i++)
      for (j = 0; j < GENES; j++)
      {
        int other = rand() % POP;
        int father = fit[other] > fit[i] ? other : best;
        next[i][j] = i == 0 ? pool[best][j] : pool[father][j] + rnd(-0.3, 0.3);
      }
    memcpy(pool, next, sizeof(pool));
  }
  printf("genes %.2f %.2f %.2f %.2f\n", pool[0][0], pool[0][1], pool[0][2], pool[0][3]);
  printf("the champion drives %.0f mm\n", evaluate(pool[0]));
  return 0;
}
