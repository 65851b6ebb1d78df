#pragma once

#include <memory>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::robot {

/// The range sensors of a type of robot, in as little memory as reading all of them needs: a
/// thousand robots of one type share it.
struct RangeLayout {
  explicit RangeLayout(const std::vector<RangeSensorModel>& models);

  /// True when readings by this layout are those of `models`.
  [[nodiscard]] bool fits(const std::vector<RangeSensorModel>& models) const;

  /// Neighbours that look equally far, from places near each other: their rays are cast at once.
  struct Fan {
    Vec2 origin;    ///< In the robot, metres: in the middle of theirs.
    double spread;  ///< Of theirs around it, metres; 0 where it is the same for all.
    double max_range;
    std::size_t first;  ///< Sensor.
    std::size_t count;

    friend bool operator==(const Fan&, const Fan&) = default;
  };
  static constexpr std::size_t kMostInFan = 16;
  static constexpr double kMostSpread = 0.5;  // metres

  // One a sensor, in the order of the model.
  std::vector<Vec2> origins;      ///< In the robot, metres.
  std::vector<Heading> headings;  ///< In the robot.
  std::vector<double> min_range;
  std::vector<double> max_range;
  std::vector<double> out_of_range;
  std::vector<Fan> fans;
  bool only_rays = true;  ///< Else these do not say everything about a reading.
  /// Unit vectors of an ultrasound sensor's rays in its own frame, from right to left, one set a
  /// sensor; none for other kinds. Empty when all are rays.
  std::vector<std::vector<Vec2>> cones;
};

/// The greatest angle between neighbouring rays of a cone, radians. An echo from between two of
/// them is taken for one of a neighbour: a wall reads too far by at most 1 - cos(this / 2), which
/// is 0.04 mm in a metre; and what is thinner than this times its range may be missed.
inline constexpr double kConeGap = deg_to_rad(1.0);

}  // namespace eyebridge::robot
