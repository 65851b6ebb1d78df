/* Gyroscope and accelerometer on a curve, and without a place to put what they say. */
#include "eyebot.h"
#include "eyebridge.h"

int main(void) {
  int rate = -1, forward = -1, left = -1;

  printf("stands %d %d", EYEBRIDGEGyroscopeGet(&rate), EYEBRIDGEAccelerometerGet(&forward, &left));
  printf(": %d, %d %d\n", rate, forward, left);
  VWSetSpeed(200, 30);
  OSWait(2000);
  EYEBRIDGEGyroscopeGet(&rate);
  EYEBRIDGEAccelerometerGet(&forward, &left);
  /* 0.2 m/s times 30 degrees a second is 105 mm/s^2 to the inside of the curve. */
  printf("curve %d, %d %d\n", rate, forward, left);
  printf("nowhere %d %d %d", EYEBRIDGEGyroscopeGet(NULL), EYEBRIDGEAccelerometerGet(NULL, &left),
         EYEBRIDGEAccelerometerGet(&forward, NULL));
  printf(": %s\n", EYEBRIDGELastError());
  return 0;
}
