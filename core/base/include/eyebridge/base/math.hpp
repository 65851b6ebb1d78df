#pragma once

namespace eyebridge {

// Elementary functions that give the same bits on every CPU and at every optimisation level.
// libm's differ between CPU generations (it picks FMA variants at run time), which would make two
// machines disagree about a simulation. Only +, -, *, / and sqrt are used here; the build switches
// floating-point contraction off. Accuracy: within 4 ulp over the stated ranges.

struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine of `angle` radians. Any finite angle gives a unit vector; beyond 1e6 the turns
/// are counted with the double nearest to 2 pi, and the error grows as |angle| * 4e-17. NaN for an
/// angle that is not finite.
SinCos sin_cos(double angle);

/// Angle of the vector (x, y) in radians, -pi … pi; 0 for the null vector. `x` and `y` are finite.
double arc_tan2(double y, double x);

/// Natural logarithm of `x`; `x` is finite and > 0.
double log_of(double x);

/// e to the power of `x`; 0 below -746, infinite above 710, NaN for NaN. Within 4 ulp, where the
/// result is not subnormal.
double exp_of(double x);

/// `angle`, radians, brought into (-pi, pi]. NaN for an angle that is not finite.
double wrap_angle(double angle);

}  // namespace eyebridge
