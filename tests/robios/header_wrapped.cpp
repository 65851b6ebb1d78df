// Some programs put the C header inside extern "C" themselves.
extern "C" {
#include <eyebot.h>
}

#include <cmath>

int wrapped_header() { return static_cast<int>(std::lround(std::sqrt(16.0))) + KEY3; }
