#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "eyebridge/robot/simulation.hpp"

namespace eyebridge::episode {

/// What a controller sees of its robot, as a row of numbers.
///
/// Words, in the order in which they are given, with blanks between:
/// `psd`      ranges of all distance sensors, by their numbers, metres, with their errors
/// `lidar`    a scan as the robot's file says, or `lidar:N` of N rays over the same field of view
/// `bumper`   1 where something touches a bumper, else 0
/// `compass`  heading in the world, radians, with its error
/// `gyroscope` rate of turn, rad/s, with its error
/// `accelerometer` forward and left, m/s^2, with their errors
/// `speed`    linear and angular speed by the wheels' encoders, m/s and rad/s
/// `odometry` x, y, theta by the wheels
/// `pose`     x, y, theta in the world: the truth
class Observer {
 public:
  /// Throws std::invalid_argument for a word that is unknown, given twice or names what `model`
  /// does not have, and for none.
  Observer(std::string_view words, const robot::RobotModel& model);

  /// How many numbers a row has.
  [[nodiscard]] std::size_t size() const { return low_.size(); }
  /// Least and greatest value of each, without errors; infinite where there is none.
  [[nodiscard]] const std::vector<double>& low() const { return low_; }
  [[nodiscard]] const std::vector<double>& high() const { return high_; }

  /// A fresh reading of every sensor of `robot`, whose model is that of the constructor. `row` has
  /// size() numbers.
  void read(robot::Simulation& simulation, robot::RobotIndex robot, std::span<double> row) const;

 private:
  enum class Kind { Psd, Lidar, Bumper, Compass, Gyroscope, Accelerometer, Speed, Odometry, Pose };
  struct Part {
    Kind kind = Kind::Psd;
    std::size_t count = 0;
  };

  void add(std::string_view word, const robot::RobotModel& model);
  void add_part(Kind kind, std::size_t count, double low, double high);
  void read_psds(robot::Simulation& simulation, robot::RobotIndex robot,
                 std::span<double> row) const;

  std::vector<Part> parts_;
  std::vector<std::size_t> psds_;  ///< Indices of the distance sensors, in order of their numbers.
  double field_of_view_ = 0.0;     ///< Of the lidar.
  std::vector<double> low_;
  std::vector<double> high_;
};

}  // namespace eyebridge::episode
