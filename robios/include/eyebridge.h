/** What EyeBridge offers to programs beyond RoBIOS-7. C and C++; independent of eyebot.h. */
#ifndef EYEBRIDGE_H
#define EYEBRIDGE_H

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/**
 * Why the last RoBIOS call of this program that failed did so: one line of text, without line end.
 * "" when none has failed. The text stays valid until the calling thread asks again. Any thread.
 */
const char* EYEBRIDGELastError(void);

/**
 * Rate of turn, hundredths of a degree per second, counter-clockwise positive, in `*rate`. 0, or 1
 * when the robot has no gyroscope (only simulated ones have) or `rate` is NULL: then nothing is
 * written. With the errors of its model ("gyroscope" in docs/errors.md). Any thread.
 */
int EYEBRIDGEGyroscopeGet(int* rate);

/**
 * Acceleration in the robot's frame, mm/s^2, in `*forward` and `*left`; gravity is not in it. 0, or
 * 1 when the robot has no accelerometer (only simulated ones have) or a pointer is NULL: then
 * nothing is written. With the errors of its model ("accelerometer"). Any thread.
 */
int EYEBRIDGEAccelerometerGet(int* forward, int* left);

/**
 * Fills distance[0 … 63] with the ranges of time-of-flight matrix number `matrix`, 1 … 8: eight
 * rows of eight zones, the top row first, each from the left; mm along the axis of the sensor, 9999
 * where nothing is within reach. 0, or 1 when the robot has no such matrix or has lost it, or
 * `distance` is NULL: then nothing is written. With the errors of its model ("tof"). Any thread.
 */
int EYEBRIDGERangeMatrixGet(int matrix, int distance[]);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
