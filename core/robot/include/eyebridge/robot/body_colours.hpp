#pragma once

#include <array>
#include <cstddef>

#include "eyebridge/base/colour.hpp"

namespace eyebridge::robot {

/// The colour of the body of the robot of this index, from 0, as every view shows it.
constexpr Rgb body_colour(std::size_t robot) {
  constexpr std::array<Rgb, 6> kColours = {{{60, 110, 220},
                                            {220, 70, 60},
                                            {60, 170, 80},
                                            {230, 180, 40},
                                            {150, 80, 190},
                                            {40, 170, 180}}};
  return kColours.at(robot % kColours.size());
}

}  // namespace eyebridge::robot
