/* Conway's game of life on the LCD */
#include "eyebot.h"
#define WIDTH 40
#define HEIGHT 25
#define MAX(a, b) ((a) > (b) ? (a) : (b))

char board[HEIGHT][WIDTH], newboard[HEIGHT][WIDTH];

int neighbours(int r, int c)
{ int i, j, n = 0;
  for (i = -1; i <= 1; i++)
    for (j = -1; j <= 1; j++)
      if (i || j) n += board[(r + i + HEIGHT) % HEIGHT][(c + j + WIDTH) % WIDTH];
  return n;
}

void draw()
{ int r, c;
  for (r = 0; r < HEIGHT; r++)
    for (c = 0; c < WIDTH; c++) LCDArea(c * 12, 40 + r * 12, c * 12 + 10, 50 + r * 12, board[r][c] ? GREEN : NAVY, 1);
}

int main()
{ int r, c, n, gen = 0, alive, most = 0, run = 1;
  srand(1);
  for (r = 0; r < HEIGHT; r++) for (c = 0; c < WIDTH; c++) board[r][c] = rand() % 4 == 0;
  LCDMenu("STEP", "RUN", "", "END");
  draw();
  while (run)
  { switch (KEYGet())
    { case KEY1: n = 1; break;
      case KEY2: n = 20; break;
      case KEY4: run = 0;
      default: n = 0;
    }
    while (n-- > 0)
    { for (r = 0; r < HEIGHT; r++)
        for (c = 0; c < WIDTH; c++)
        { int k = neighbours(r, c);
          newboard[r][c] = k == 3 || (k == 2 && board[r][c]);
        }
      memcpy(board, newboard, sizeof(board));
      gen++;
      draw();
      usleep(10 * 1000);
    }
    for (alive = 0, r = 0; r < HEIGHT; r++) for (c = 0; c < WIDTH; c++) alive += board[r][c];
    most = MAX(most, alive);
    LCDSetPrintf(0, 0, "generation %3d, %3d cells alive  ", gen, alive);
    printf("generation %d: %d\n", gen, alive);
  }
  printf("most %d\n", most);
  return 0;
}
