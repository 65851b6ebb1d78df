/* Turn until the green wall, then the blue one is in the middle. (imgtools.c has the rest) */
#include "imgtools.h"

BYTE *image;

int look_for(int hue, char *name)
{
  Blob b;
  int x, y, phi, tries = 0;
  do
  {
    CAMGet(image);
    LCDImage(image);
    b = find_colour(image, hue);
    if (b.n > 300) cross(b.x, b.y, YELLOW);
    VWTurn(b.n > 300 ? (QQVGA_X / 2 - b.x) / 4 : 20, 60);
    VWWait();
  } while (++tries < 40 && (b.n <= 300 || abs(QQVGA_X / 2 - b.x) > 6));
  VWGetPosition(&x, &y, &phi);
  LCDSetPrintf(10 + hue % 2, 0, "%-6s in the middle", name);
  printf("%s after %s\n", name, tries < 40 ? "some turns" : "all turns");
  return phi;
}

int main()
{
  int a, b;
  image = malloc(QQVGA_SIZE);
  CAMInit(QQVGA);
  a = look_for(128, "green");
  b = look_for(213, "blue");
  printf("between them about %d degrees\n", (((b - a + 360) % 360) + 15) / 30 * 30);
  free(image);
  CAMRelease();
  return 0;
}
