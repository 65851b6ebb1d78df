#pragma once

#include <optional>

#include "eyebridge/robot/robot_model.hpp"
#include "text.hpp"

namespace eyebridge::files {

/// Reads the lines of a `.robi` file about what makes the robot move: `drive`, `wheel`, `axel`,
/// `speed`, `turn`, and our own `axles`, `steering` and `dive`. They may come in any order.
class DriveLines {
 public:
  explicit DriveLines(Warnings& warnings) : warnings_(warnings) {}

  /// True when the line was one of these. Throws ConfigError. In the new dialect `wheel` gives half
  /// the distance of the wheels.
  bool read(const Statement& s, bool new_dialect);
  /// Puts what was read into `model`, after the last line. Throws ConfigError for lines that do not
  /// go together.
  void finish(robot::RobotModel& model);
  /// Whether there was a `wheel` line for driven wheels.
  [[nodiscard]] bool has_wheels() const { return wheels_; }

 private:
  /// The `steering` line.
  struct Steering {
    SourceLocation where;
    double most = 0.0;   ///< Radians.
    unsigned servo = 0;  ///< Index.
    SourceLocation servo_where;
    double speed = 0.0;  ///< Radians per second; 0: at once.
  };
  /// The `dive` line of a submarine; what it is like without one.
  struct Dive {
    SourceLocation where;
    double vertical = 0.25;  ///< Up or down by its thrusters, metres per second.
    double rise = 0.02;      ///< Up without them, metres per second; negative: it sinks.
    double glide = 1.0;      ///< Time constant of its drag, seconds.
  };
  /// Where an axle lies, by `axel`.
  struct Axle {
    SourceLocation where;
    double x = 0.0;  ///< Metres.
  };

  void read_drive(const Statement& s);
  void read_wheel(const Statement& s, bool new_dialect);
  void read_axel(const Statement& s);
  void read_steering(const Statement& s);
  void read_dive(const Statement& s);
  void finish_axles(robot::DriveModel& drive) const;
  void finish_steering(robot::RobotModel& model) const;
  void finish_submarine(robot::DriveModel& drive) const;

  Warnings& warnings_;
  robot::DriveModel drive_;
  int line_ = 1;  ///< Of `drive`.
  bool wheels_ = false;
  std::optional<double> speed_;
  std::optional<double> turn_;
  std::optional<double> axles_;
  std::optional<Axle> rear_;
  std::optional<Axle> front_;
  std::optional<Steering> steering_;
  std::optional<Dive> dive_;
};

}  // namespace eyebridge::files
