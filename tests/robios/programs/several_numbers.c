// Several robots that draw numbers and cut up texts, and wait between them.
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <eyebot.h>

/* One line at a time, whoever else prints. */
static char line[4000];
static size_t length;

static void show(const char* what, double value) {
  length += (size_t)snprintf(line + length, sizeof line - length, " %s%.6g", what, value);
  OSWait(3);
}

static void draw(void) {
  for (int i = 0; i < 3; ++i) show("r", rand());
  srand(42);
  for (int i = 0; i < 3; ++i) show("s", (double)random());
  static char table[64];
  char* const before = initstate(5, table, sizeof table);
  for (int i = 0; i < 2; ++i) show("i", rand());
  char* const mine = setstate(before);
  show("b", rand());
  setstate(mine);
  show("m", rand());
  show("d", drand48());
  srand48(9);
  show("l", (double)lrand48());
  show("j", (double)mrand48());
  unsigned short seed[3] = {1, 2, 3};
  unsigned short parameters[7] = {1, 2, 3, 4, 5, 6, 7};
  show("e", erand48(seed));
  show("n", (double)nrand48(seed));
  const unsigned short* const old = seed48(seed);
  show("o", old[0] + old[1] + old[2]);
  show("d", drand48());
  lcong48(parameters);
  show("c", (double)jrand48(seed));
}

int main(void) {
  OSWait(OSMachineID());
  draw();
  char words[] = "1 22,333 4444";
  for (char* word = strtok(words, " ,"); word != NULL; word = strtok(NULL, " ,")) {
    show("w", atof(word));
    OSWait(OSMachineID());
  }
  printf("%s\n", line);
  return 0;
}
