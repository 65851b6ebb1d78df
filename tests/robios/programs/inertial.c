/* Gyroscope and accelerometer on a curve, and without a place to put what they say. */
#include "eyebot.h"
#include "eyebridge.h"

int main(void) {
  int rate = -1, forward = -1, left = -1, codes[3];

  /* One call a statement: compilers for arm64 and x86-64 evaluate arguments in different orders. */
  codes[0] = EYEBRIDGEAccelerometerGet(&forward, &left);
  codes[1] = EYEBRIDGEGyroscopeGet(&rate);
  printf("stands %d %d: %d, %d %d\n", codes[1], codes[0], rate, forward, left);
  VWSetSpeed(200, 30);
  OSWait(2000);
  EYEBRIDGEGyroscopeGet(&rate);
  EYEBRIDGEAccelerometerGet(&forward, &left);
  /* 0.2 m/s times 30 degrees a second is 105 mm/s^2 to the inside of the curve. */
  printf("curve %d, %d %d\n", rate, forward, left);
  codes[0] = EYEBRIDGEAccelerometerGet(&forward, NULL);
  codes[1] = EYEBRIDGEAccelerometerGet(NULL, &left);
  codes[2] = EYEBRIDGEGyroscopeGet(NULL);
  printf("nowhere %d %d %d: %s\n", codes[2], codes[1], codes[0], EYEBRIDGELastError());
  return 0;
}
