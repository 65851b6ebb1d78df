#ifndef EB_MATH_H
#define EB_MATH_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Small replacements for math.h, which a bare board may lack. */

#define EB_DEGREE 0.017453292519943295F /* radians */

static inline int32_t eb_clamp(int32_t value, int32_t low, int32_t high) {
  return value < low ? low : value > high ? high : value;
}
static inline float eb_limit(float value, float low, float high) {
  return value < low ? low : value > high ? high : value;
}
static inline float eb_abs(float value) { return value < 0.0F ? -value : value; }

/* To the nearest integer; beyond +-2e9 it is clamped. */
int32_t eb_round(float value);
/* Square root of a value >= 0. */
float eb_sqrt(float value);
/* Sine and cosine of an angle in 2^-32 of a turn. Error below 1e-6. */
void eb_sin_cos(uint32_t turn, float* sine, float* cosine);

#ifdef __cplusplus
}
#endif

#endif
