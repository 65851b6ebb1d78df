// Random drive (Lab 2): straight until something is close, then turn a random angle.
// Writes what happened to random.csv
#include "eyebot.h"
#include <stdio.h>
#include <stdlib.h>

#define SAFE 250

int main()
{
  FILE *fp;
  int i, dir, x, y, phi, t = 0;

  fp = fopen("random.csv", "w");
  fprintf(fp, "run;x;y;phi;turn\n");
  LCDMenu("", "", "", "END");
  for (i = 0; i < 10; i++)
  {
    // drive as long as the way is free
    VWSetSpeed(250, 0);
    while (PSDGet(PSD_FRONT) > SAFE && PSDGet(PSD_LEFT) > SAFE/3 && PSDGet(PSD_RIGHT) > SAFE/3)
    {
      OSWait(50);
      t++;
      if (KEYRead() == KEY4) break;
      if (t > 2000) break;
    }
    VWStraight(-40, 50); VWWait();
    dir = ((rand() % 181) - 90) + 180;
    VWTurn(dir, 90);
    VWWait();
    VWGetPosition(&x, &y, &phi);
    LCDPrintf("%2d: turned %d, now at %d %d\n", i, dir, x, y);
    fprintf(fp, "%d;%d;%d;%d;%d\n", i, x, y, phi, dir);
  }
  fclose(fp);

  // read it again
  char line[80];
  int lines = 0;
  fp = fopen("random.csv", "r");
  while (fgets(line, 80, fp)) lines++;
  fclose(fp);
  printf("%d lines in random.csv\n", lines);
  return 0;
}
