#include "board_views.hpp"

#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge::camera::testing {

Calibration bent_webcam() {
  Calibration lens = pinhole({320, 240}, deg_to_rad(62.0));
  lens.distortion = {-0.25, 0.06, 0.001, -0.001, 0.0};
  lens.cx += 4.0;
  return lens;
}

std::vector<EyePose> board_views(double distance) {
  std::vector<EyePose> eyes;
  for (int i = 0; i < 12; ++i) {
    const double aside = -0.5 + (i % 4) / 3.0;
    const int row = i / 4;
    const double above = 0.45 * (row - 1);
    // Past the board's middle, each time to another side.
    const double heading = std::atan(aside) + 0.3 * std::cos(2.4 * i);
    const double pitch = -std::atan(0.7 * above) + 0.13 * std::sin(2.4 * i);
    eyes.push_back({{distance * aside, -distance, 0.7 * distance * above, kPi / 2 + heading, pitch,
                     0.2 * aside}});
  }
  return eyes;
}

}  // namespace eyebridge::camera::testing
