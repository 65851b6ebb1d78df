/* As C was written when these robots were new. */
#include "eyebot.h"
static limit = 2;
count(n) { return n < limit ? n : limit; }
int main() {
  printf("counted %d, root %.1f\n", count(5), sqrt(4.0));
  later();
  return 0;
}
later() { printf("later\n"); }
