/* A time-of-flight matrix before a wall, one that is not there, and without room. */
#include "eyebot.h"
#include "eyebridge.h"

int main(void) {
  int zones[64], code, i;
  code = EYEBRIDGERangeMatrixGet(1, zones);
  printf("ahead %d: %d %d, floor %d\n", code, zones[0], zones[7], zones[63]);
  for (i = 0; i < 64; ++i) zones[i] = -7;
  code = EYEBRIDGERangeMatrixGet(2, zones);
  printf("missing %d, %d: %s\n", code, zones[0], EYEBRIDGELastError());
  code = EYEBRIDGERangeMatrixGet(1, NULL);
  printf("nowhere %d: %s\n", code, EYEBRIDGELastError());
  return 0;
}
