/* Maze exploration with recursive search, then flood fill for the shortest way to the
   farthest corner and back. Walls are kept in two arrays as in the lecture. */
#include "eyebot.h"

#define MAZESIZE 5
#define CELL 360
#define THRES 280
#define MAXPATH (MAZESIZE * MAZESIZE)

int mark[MAZESIZE][MAZESIZE];
int wall[MAZESIZE + 1][MAZESIZE + 1][2];   // [y][x][0]: below the cell, [1]: left of it
int map[MAZESIZE][MAZESIZE];
int path[MAXPATH];
int rob_x, rob_y, rob_dir;   // dir: 0 up, 1 left, 2 down, 3 right

int xneighbor(int x, int d) { return d == 1 ? x - 1 : d == 3 ? x + 1 : x; }
int yneighbor(int y, int d) { return d == 0 ? y + 1 : d == 2 ? y - 1 : y; }

void draw_wall(int x, int y, int w)
{
  if (w == 0) LCDLine(300 + 40 * x, 250 - 40 * y, 340 + 40 * x, 250 - 40 * y, WHITE);
  else        LCDLine(300 + 40 * x, 250 - 40 * y, 300 + 40 * x, 210 - 40 * y, WHITE);
}

void set_wall(int x, int y, int d)
{
  if (d == 0) { wall[y + 1][x][0] = 1; draw_wall(x, y + 1, 0); }
  if (d == 2) { wall[y][x][0] = 1;     draw_wall(x, y, 0); }
  if (d == 1) { wall[y][x][1] = 1;     draw_wall(x, y, 1); }
  if (d == 3) { wall[y][x + 1][1] = 1; draw_wall(x + 1, y, 1); }
}

int is_open(int x, int y, int d)
{
  if (d == 0) return !wall[y + 1][x][0];
  if (d == 2) return !wall[y][x][0];
  if (d == 1) return !wall[y][x][1];
  return !wall[y][x + 1][1];
}

void go_to(int d)
{
  int turn = (d - rob_dir + 4) % 4;
  if (turn == 3) turn = -1;
  if (turn) { VWTurn(turn * 90, 120); VWWait(); }
  VWStraight(CELL, 400);
  VWWait();
  rob_dir = d;
  rob_x = xneighbor(rob_x, d);
  rob_y = yneighbor(rob_y, d);
  LCDCircle(320 + 40 * rob_x, 230 - 40 * rob_y, 5, RED, 1);
}

void check_walls()
{
  if (PSDGet(PSD_FRONT) < THRES) set_wall(rob_x, rob_y, rob_dir);
  if (PSDGet(PSD_LEFT)  < THRES) set_wall(rob_x, rob_y, (rob_dir + 1) % 4);
  if (PSDGet(PSD_RIGHT) < THRES) set_wall(rob_x, rob_y, (rob_dir + 3) % 4);
  mark[rob_y][rob_x] = 1;
}

void explore()
{
  int d, back, x = rob_x, y = rob_y;
  check_walls();
  for (d = 0; d < 4; d++)
    if (is_open(x, y, d))
    {
      int nx = xneighbor(x, d), ny = yneighbor(y, d);
      if (nx < 0 || ny < 0 || nx >= MAZESIZE || ny >= MAZESIZE || mark[ny][nx]) continue;
      go_to(d);
      explore();
      back = (d + 2) % 4;
      go_to(back);
    }
}

int build_path(int x, int y)   // from the start to x,y
{
  int i, d, len = map[y][x];
  for (i = len - 1; i >= 0; i--)
    for (d = 0; d < 4; d++)
    {
      int nx = xneighbor(x, d), ny = yneighbor(y, d);
      if (is_open(x, y, d) && nx >= 0 && ny >= 0 && nx < MAZESIZE && ny < MAZESIZE && map[ny][nx] == i)
      {
        x = nx; y = ny; path[i] = (d + 2) % 4;
        break;
      }
    }
  return len;
}

int main()
{
  int i, x, y, d, change, len, goalx = MAZESIZE - 1, goaly = MAZESIZE - 1;

  LCDMenu("GO", "", "", "END");
  LCDPrintf("MAZE: explore\n");
  KEYWait(KEY1);
  wall[0][0][0] = 1; draw_wall(0, 0, 0);   // behind the start
  explore();

  for (y = 0; y < MAZESIZE; y++) for (x = 0; x < MAZESIZE; x++) map[y][x] = -1;
  map[0][0] = 0;
  do
  {
    change = 0;
    for (y = 0; y < MAZESIZE; y++) for (x = 0; x < MAZESIZE; x++)
      if (map[y][x] < 0)
        for (d = 0; d < 4; d++)
          if (is_open(x, y, d))
          {
            int nx = xneighbor(x, d), ny = yneighbor(y, d);
            if (nx < 0 || ny < 0 || nx >= MAZESIZE || ny >= MAZESIZE) continue;
            if (map[ny][nx] >= 0 && map[y][x] < 0) { map[y][x] = map[ny][nx] + 1; change = 1; }
          }
  } while (change);

  for (y = MAZESIZE - 1; y >= 0; y--)
  {
    for (x = 0; x < MAZESIZE; x++) { printf("%4d", map[y][x]); LCDSetPrintf(3 + MAZESIZE - y, 4 * x, "%3d", map[y][x]); }
    printf("\n");
  }
  len = build_path(goalx, goaly);
  LCDSetPrintf(1, 0, "drive %d cells to the corner", len);
  for (i = 0; i < len; i++) go_to(path[i]);
  printf("in the corner: %d %d after %d cells\n", rob_x, rob_y, len);
  LCDSetPrintf(2, 0, "back home");
  for (i = len - 1; i >= 0; i--) go_to((path[i] + 2) % 4);
  printf("home: %d %d\n", rob_x, rob_y);
  return 0;
}
