#include "eb_math.h"

int32_t eb_round(float value) {
  const float limited = eb_limit(value, -2.0e9F, 2.0e9F);
  return (int32_t)(limited < 0.0F ? limited - 0.5F : limited + 0.5F);
}

float eb_sqrt(float value) {
  float scale = 1.0F;
  float root;
  int i;
  if (!(value > 0.0F)) return 0.0F;
  if (value > 1.0e30F) return 1.0e15F;
  /* Into 1 ... 4, where four Newton steps from 1.5 are exact. */
  for (; value >= 4.0F; value /= 4.0F) scale *= 2.0F;
  for (; value < 1.0F && scale > 1.0e-18F; value *= 4.0F) scale /= 2.0F;
  root = 1.5F;
  for (i = 0; i < 4; ++i) root = 0.5F * (root + value / root);
  return root * scale;
}

void eb_sin_cos(uint32_t turn, float* sine, float* cosine) {
  const uint32_t quadrant = (turn + 0x20000000U) >> 30U & 3U;
  const uint32_t rest = turn - (quadrant << 30U);
  /* |x| <= pi / 4 */
  const float signed_rest = rest < 0x80000000U ? (float)rest : -(float)(0xFFFFFFFFU - rest) - 1.0F;
  const float x = signed_rest * 1.4629180792671596e-9F; /* 2 pi / 2^32 */
  const float z = x * x;
  const float s = x * (1.0F + z * (-1.0F / 6.0F + z * (1.0F / 120.0F - z / 5040.0F)));
  const float c = 1.0F + z * (-0.5F + z * (1.0F / 24.0F + z * (-1.0F / 720.0F + z / 40320.0F)));
  switch (quadrant) {
    case 0:
      *sine = s;
      *cosine = c;
      break;
    case 1:
      *sine = c;
      *cosine = -s;
      break;
    case 2:
      *sine = -s;
      *cosine = -c;
      break;
    default:
      *sine = -c;
      *cosine = s;
      break;
  }
}
