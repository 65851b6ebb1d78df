/* reads nodes.txt, finds the way with A*, writes way.txt and drives it */
#include "eyebot.h"
#define MAXN 30

int n, m, x[MAXN], y[MAXN];
int edge[MAXN][MAXN];
double score[MAXN], best[MAXN];
int prev[MAXN], open[MAXN], closed[MAXN];

double len(int a, int b) { return sqrt((x[a] - x[b]) * (x[a] - x[b]) + (y[a] - y[b]) * (y[a] - y[b])); }

void load(char *file)
{
  FILE *f = fopen(file, "r");
  char line[200], *word;
  while (fgets(line, sizeof(line), f))
  {
    if (line[0] == '#') continue;
    word = strtok(line, " \n");
    if (!word) continue;
    if (strcmp(word, "node") == 0)
    { x[n] = atoi(strtok(NULL, " \n")); y[n] = atoi(strtok(NULL, " \n")); n++; }
    else if (strcmp(word, "edge") == 0)
    { int a = atoi(strtok(NULL, " \n")), b = atoi(strtok(NULL, " \n")); edge[a][b] = edge[b][a] = 1; m++; }
  }
  fclose(f);
}

int astar(int start, int goal)
{
  int i, c;
  for (i = 0; i < n; i++) { best[i] = 1e9; prev[i] = -1; }
  best[start] = 0; score[start] = len(start, goal); open[start] = 1;
  while (1)
  {
    c = -1;
    for (i = 0; i < n; i++) if (open[i] && (c < 0 || score[i] < score[c])) c = i;
    if (c < 0) return 0;
    if (c == goal) return 1;
    open[c] = 0; closed[c] = 1;
    for (i = 0; i < n; i++)
      if (edge[c][i] && !closed[i] && best[c] + len(c, i) < best[i])
      { best[i] = best[c] + len(c, i); score[i] = best[i] + len(i, goal); prev[i] = c; open[i] = 1; }
  }
}

void drive_to(int tx, int ty)
{
  int px, py, phi, a;
  VWGetPosition(&px, &py, &phi);
  a = (int)(atan2(ty - py, tx - px) * 180 / M_PI) - phi;
  if (a > 180) a -= 360;
  if (a < -180) a += 360;
  VWTurn(a, 90); VWWait();
  VWStraight((int)sqrt((tx - px) * (tx - px) + (ty - py) * (ty - py)), 300); VWWait();
}

int main(int argc, char **argv)
{
  int i, j, k = 0, way[MAXN];
  FILE *out;

  load(argc > 1 ? argv[1] : "nodes.txt");
  for (i = 0; i < n; i++) for (j = 0; j < i; j++) if (edge[i][j]) LCDLine(x[i] / 10, 350 - y[i] / 12, x[j] / 10, 350 - y[j] / 12, GRAY);
  for (i = 0; i < n; i++) { LCDCircle(x[i] / 10, 350 - y[i] / 12, 6, CYAN, 1); LCDSetPrintf(i, 60, "%2d: %4d %4d", i, x[i], y[i]); }
  printf("%d nodes, %d edges\n", n, m);
  if (!astar(0, n - 1)) { printf("no way\n"); exit(1); }
  for (i = n - 1; i >= 0; i = prev[i]) way[k++] = i;

  out = fopen("way.txt", "w");
  for (i = k - 1; i >= 0; i--) fprintf(out, "%d %d\n", x[way[i]], y[way[i]]);
  fclose(out);
  printf("way of %.0f mm over %d nodes\n", best[n - 1], k);
  VWSetPosition(x[0], y[0], 90);
  for (i = k - 2; i >= 0; i--)
  {
    LCDLine(x[way[i + 1]] / 10, 350 - y[way[i + 1]] / 12, x[way[i]] / 10, 350 - y[way[i]] / 12, RED);
    drive_to(x[way[i]], y[way[i]]);
  }
  VWGetPosition(&i, &j, &k);
  printf("arrived at %d %d\n", i, j);
}
