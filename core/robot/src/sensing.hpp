#pragma once

#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::robot {

/// True when `bearing` lies in the sector that goes counter-clockwise from `start` to `end`, both
/// ends included; radians, any number of turns. `end` a whole turn or more beyond `start` is the
/// full circle; `end` at `start` is that one bearing.
bool in_sector(double bearing, double start, double end);

/// Where a device looks from and to, once its pose in the robot is known.
struct Sight {
  Vec2 origin;
  Heading heading;

  explicit Sight(const Pose& pose)
      : origin(pose.position()), heading(Heading::from_angle(pose.theta)) {}
  Sight(Vec2 from, Heading towards) : origin(from), heading(towards) {}

  /// This sight, of a robot that stands at `position` with `robot_heading`.
  [[nodiscard]] Sight in_world(Vec2 position, Heading robot_heading) const {
    return {position + robot_heading.rotate(origin), robot_heading.turned(heading)};
  }
};

/// Bearings of a scan in the lidar's frame, in the order of Simulation::read_lidar().
struct ScanShape {
  /// `points` rays over `field_of_view` radians.
  ScanShape(double field_of_view, std::size_t points);

  double field_of_view;          ///< Radians.
  std::vector<Vec2> directions;  ///< Unit vectors.
  /// From one bearing to the next, radians, < 0; 0 where they go round more than once.
  double gap;
};

/// The shapes that robots scan by, so that trigonometry is paid once for each; many robots with the
/// same lidar share it, and the processor's cache. A few are kept.
class ScanShapes {
 public:
  /// Valid until the next call.
  const ScanShape& of(double field_of_view, std::size_t points);

 private:
  static constexpr std::size_t kMost = 8;
  std::vector<ScanShape> shapes_;  ///< The one that was asked for last is the first.
};

/// The reading of a range sensor whose ray meets something after `range` metres; `range` at or
/// beyond the sensor's reach is nothing met. Draws from `random` only for a reading with error.
/// `cross_talkers` other sensors are in earshot: each that sends while this one listens is heard at
/// a moment that is evenly spread over the time that an echo may take, and what is heard first
/// counts.
double range_reading(double range, const RangeSensorModel& model, Random& random,
                     unsigned cross_talkers = 0);
/// The same without the sensor's error.
double range_reading(double range, const RangeSensorModel& model);

/// Where on the long branch of its curve an infrared sensor takes something to be that is `range`
/// metres away; infinite where its signal is nothing.
double folded_range(double range, const RangeSensorModel& model);

/// Throws std::invalid_argument for a sensor that cannot be: a beam that is no cone, an angle
/// beyond a right one, a curve without a greatest value.
void check_range_sensor(const RangeSensorModel& model);

/// A lidar tilted down by `tilt` radians measures along its slanted rays.
class SlantedBeam {
 public:
  SlantedBeam(const LidarModel& model, double tilt);

  /// How far a level ray has to look, metres over the floor.
  [[nodiscard]] double level_reach() const { return level_reach_; }
  /// The range along the beam for something met `level` metres away over the floor: the floor
  /// itself where the beam ends there, the lidar's reach where nothing is met.
  [[nodiscard]] double range(double level) const;
  /// True when range() changes nothing of what is no farther than level_reach().
  [[nodiscard]] bool is_level() const { return cosine_ == 1.0 && miss_ == level_reach_; }

 private:
  double max_range_;
  double level_reach_;
  double miss_;  // what a beam reads that meets no wall
  double cosine_;
};

}  // namespace eyebridge::robot
