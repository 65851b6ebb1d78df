/* reads the way from a file that is not there */
#include "eyebot.h"

int nodes[100][2];

int read_nodes(char *name)
{
  FILE *f = fopen(name, "r");
  int n = 0;
  if (f == NULL)
  {
    fprintf(stderr, "cannot open %s\n", name);
    LCDSetPrintf(3, 0, "cannot open %s", name);
    exit(EXIT_FAILURE);
  }
  while (fscanf(f, "%d %d", &nodes[n][0], &nodes[n][1]) == 2) n++;
  fclose(f);
  return n;
}

int main(int argc, char *argv[])
{
  int n;
  VWSetSpeed(200, 20);     /* already moving */
  sleep(1);
  printf("%d arguments, first is %s\n", argc - 1, argc > 1 ? argv[1] : "-");
  n = read_nodes(argc > 1 ? argv[1] : "way.txt");
  printf("%d nodes\n", n);
  VWSetSpeed(0, 0);
  return 0;
}
