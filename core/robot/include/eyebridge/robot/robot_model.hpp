#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/robot/drive_kind.hpp"
#include "eyebridge/robot/error_models.hpp"

namespace eyebridge::robot {

// Definition structs: every field has a usable default, every one names its unit. The defaults are
// those of an S4-sized EyeBot; readers of .robi and eyesim.p overwrite what their file says.

/// By what a distance sensor measures.
enum class RangeKind {
  Ray,         ///< Along one ray, exactly: what EyeSim calls a PSD.
  Ultrasound,  ///< The first echo out of a cone.
  Infrared,    ///< Along one ray, by triangulation: near things read as if they were far.
  Down,        ///< Straight down to the floor, exactly.
};

/// What an ultrasound sensor hears.
struct UltrasoundModel {
  double beam_width = deg_to_rad(30);  ///< Whole opening angle of its cone, radians, 0 … pi.
  /// Surfaces that a ray of the cone meets at a larger angle of incidence (to their normal),
  /// radians, mirror the sound away. 0 … pi/2; pi/2 is a rough surface, which is always heard.
  double critical_angle = deg_to_rad(25);

  friend bool operator==(const UltrasoundModel&, const UltrasoundModel&) = default;
};

/// The curve of a triangulating infrared sensor. Its signal is one over (range + `offset`) from
/// `min_range` of the sensor on; nearer things lower it again, on a straight line, to `contact` of
/// the greatest one where they touch. Who takes that signal for one of the long branch reads a
/// nearer thing as a farther one.
struct InfraredModel {
  double offset = 0.0042;  ///< Metres.
  double contact = 0.3;    ///< Share of the greatest signal, 0 … 1.

  friend bool operator==(const InfraredModel&, const InfraredModel&) = default;
};

/// A distance sensor (PSD).
struct RangeSensorModel {
  int id = 1;                   ///< As programs ask for it: PSDGet(id).
  std::string name;             ///< "PSD_FRONT"
  Pose pose_in_robot;           ///< Metres, radians; the ray leaves along theta.
  double height = 0.03;         ///< Metres above the floor, or a submarine's underside.
  double min_range = 0.0;       ///< Nearer surfaces read as `out_of_range`, or farther (Infrared).
  double max_range = 9.999;     ///< Farther surfaces read as `out_of_range`, metres.
  double out_of_range = 9.999;  ///< Metres: EyeSim's 9999 mm.
  RangeError error{};
  int semantics = 0;   ///< As classic programs ask for it, PSDInit(-205); 0: by name only.
  RangeTable table{};  ///< What `error.quantised` rounds to; empty: the sensor has no table.
  RangeKind kind = RangeKind::Ray;
  UltrasoundModel ultrasound{};  ///< Of that kind.
  InfraredModel infrared{};      ///< Of that kind.

  friend bool operator==(const RangeSensorModel&, const RangeSensorModel&) = default;
};

/// An infrared proximity switch: true when something is nearer than `threshold`.
struct ProximityModel {
  int id = 1;
  std::string name;
  Pose pose_in_robot;
  double threshold = 0.15;  ///< Metres.
  ProximityError error{};
  int semantics = 0;  ///< As RangeSensorModel's.

  friend bool operator==(const ProximityModel&, const ProximityModel&) = default;
};

/// A bumper: true when something touches the rim between two bearings.
struct BumperModel {
  int id = 1;
  std::string name;
  double start = 0.0;  ///< Bearing in the robot, radians; the sector goes
  double end = 0.0;    ///< counter-clockwise from `start` to `end`.
  BumperError error{};
  int semantics = 0;  ///< As RangeSensorModel's.

  friend bool operator==(const BumperModel&, const BumperModel&) = default;
};

/// A scanning range sensor.
struct LidarModel {
  int points = 360;
  double field_of_view = 2 * kPi;  ///< Radians, centred on the front.
  double tilt = 0.0;               ///< Radians, positive down.
  Pose pose_in_robot;
  double height = 0.1;       ///< Metres above the floor.
  double max_range = 9.999;  ///< Metres; also what "nothing hit" reads.
  LidarError error{};

  friend bool operator==(const LidarModel&, const LidarModel&) = default;
};

/// Rows, and zones of a row, of every range matrix.
inline constexpr std::size_t kMatrixSize = 8;

/// A matrix of ranges by time of flight, as the VL53L5CX has: `kMatrixSize` rows of as many zones,
/// each a cone of its own.
struct RangeMatrixModel {
  int id = 1;
  std::string name;
  Pose pose_in_robot;
  double height = 0.05;                     ///< Metres above the floor.
  double tilt = 0.0;                        ///< Radians, positive down.
  double field_of_view = deg_to_rad(45.0);  ///< Of all zones, to either side and up and down.
  double max_range = 4.0;                   ///< Metres; what is farther reads as `out_of_range`.
  double out_of_range = 9.999;              ///< Metres.
  RangeMatrixError error{};
  int semantics = 0;  ///< As RangeSensorModel's.

  friend bool operator==(const RangeMatrixModel&, const RangeMatrixModel&) = default;
};

/// Where the camera sits and how it looks.
struct CameraModel {
  double x = 0.06;                   ///< Forward of the robot's centre, metres.
  double y = 0.0;                    ///< Left of it, metres.
  double z = 0.06;                   ///< Above the floor, metres.
  double pan = 0.0;                  ///< Radians, left positive, servo at its middle.
  double tilt = 0.0;                 ///< Radians, up positive, servo at its middle.
  double max_pan = deg_to_rad(90);   ///< Servo 1's throw to either side, radians.
  double max_tilt = deg_to_rad(90);  ///< Servo 2's throw to either side, radians.
  double horizontal_field_of_view = deg_to_rad(60);  ///< Radians.
  CameraError error{};

  friend bool operator==(const CameraModel&, const CameraModel&) = default;
};

/// A servo with a lever that kicks a ball which lies in front of the robot: straight ahead, each
/// time that it is set from below to above three quarters of its throw.
struct KickerModel {
  unsigned servo = 2;   ///< Index: programs call it servo + 1. Not 0, 1: the camera's.
  double speed = 1.5;   ///< Of the ball, beyond the robot's own, metres per second.
  double reach = 0.03;  ///< Between robot and ball, metres.
  double half_angle = deg_to_rad(20);  ///< The ball's centre lies at most this far off the front.

  friend bool operator==(const KickerModel&, const KickerModel&) = default;
};

/// A servo of the robot beside those of the camera, the kicker and the steering.
struct ServoModel {
  enum class Wheel : char { None, Left, Right };

  unsigned servo = 6;  ///< Index: programs call it servo + 1. Not 0, 1: the camera's.
  std::string name;    ///< "SERVO_LEFT"
  /// The wheel of a differential drive that it turns, as a servo without end stops does: it stands
  /// within one of 254 steps about its middle, and turns forward with full speed at 1. None: an arm
  /// or the like, which moves nothing in the plane.
  Wheel wheel = Wheel::None;

  friend bool operator==(const ServoModel&, const ServoModel&) = default;
};

/// Driven wheels and the controller over them.
struct DriveModel {
  DriveKind kind = DriveKind::Differential;
  /// Distance between left and right wheels, metres (Ackermann: the rear ones). Swedish: twice the
  /// distance of a wheel from the centre. Submarine: track width of an equivalent differential
  /// drive, 2 * max_linear / max_angular.
  double wheel_base = 0.09;
  double wheel_diameter = 0.054;         ///< Metres.
  double ticks_per_revolution = 1100;    ///< Encoder ticks a wheel turn.
  double max_wheel_speed = 62.83;        ///< Radians per second of the wheel.
  double max_linear = 0.6;               ///< Metres per second.
  double max_angular = deg_to_rad(300);  ///< Radians per second.
  double linear_acceleration = 1.0;      ///< Metres per second squared; 0 = no ramp.
  double angular_acceleration = 10.0;    ///< Radians per second squared; 0 = no ramp.
  double motor_time_constant = 0.0;  ///< Seconds until a wheel has 63 % of its speed; 0 = at once.
  double axle_distance = 0.12;       ///< From rear to front axle, metres. Ackermann, Omni.
  double rear_axle = 0.0;            ///< x of the rear axle in the robot, metres. Ackermann.
  /// Most that the middle of the front wheels turns to either side, radians, < pi/2. Ackermann.
  double max_steering = deg_to_rad(45);
  double steering_speed =
      0.0;  ///< Of the front wheels, radians per second; 0 = at once. Ackermann.
  unsigned steering_servo = 0;  ///< Index: programs call it servo + 1. Ackermann.
  // A submarine's thrusters 0 and 2 are wheels to this model: at full duty they take it forward at
  // the rim speed of max_wheel_speed. Its drag is linear, with motor_time_constant.
  double max_vertical = 0.25;  ///< Up or down, thrusters 1 and 3 at full duty, metres per second.
  double rise_speed = 0.02;  ///< Up by buoyancy, without thrust, metres per second; < 0: it sinks.

  [[nodiscard]] const DriveFacts& facts() const { return facts_of(kind); }
  /// How many motors there are, and how many encoders.
  [[nodiscard]] unsigned motor_count() const {
    return static_cast<unsigned>(facts().motors.size());
  }
  [[nodiscard]] unsigned encoder_count() const {
    return static_cast<unsigned>(facts().encoders.size());
  }
  /// How much of the speed of a wheel's rim a turn takes, metres a radian; 0 where the steering
  /// does it.
  [[nodiscard]] double turn_arm() const {
    return facts().wheel_base_share * wheel_base + facts().axle_share * axle_distance;
  }
  /// Sharpest curve, 1 / metres: tan(max_steering) / axle_distance of an Ackermann drive; the
  /// others know no limit: infinite.
  [[nodiscard]] double max_curvature() const;
  /// Whether servo number `servo` (an index) turns the front wheels.
  [[nodiscard]] bool steers(unsigned servo) const {
    return facts().steers_front() && servo == steering_servo;
  }
  friend bool operator==(const DriveModel&, const DriveModel&) = default;
};

/// Everything about one type of robot.
struct RobotModel {
  std::string name = "S4";
  double diameter = 0.186;        ///< Of the disc that stands for its body, metres.
  double height = 0.10;           ///< Metres.
  double contact_friction = 0.3;  ///< Of its rim against what it meets: world::ContactLaw.
  DriveModel drive;
  DriveError drive_error;
  std::vector<RangeSensorModel> range_sensors;
  std::vector<ProximityModel> proximity_sensors;
  std::vector<BumperModel> bumpers;
  std::optional<LidarModel> lidar;
  std::vector<RangeMatrixModel> range_matrices;
  std::optional<CameraModel> camera;
  std::optional<KickerModel> kicker;
  std::vector<ServoModel> servos;
  CompassError compass_error;
  GyroscopeError gyroscope_error;
  AccelerometerError accelerometer_error;
  RadioError radio_error;

  [[nodiscard]] double radius() const { return diameter / 2; }
  /// Indices of all servos: 0 pan and 1 tilt always, then those of the kicker, the steering and
  /// `servos`; each once, in ascending order.
  [[nodiscard]] std::vector<unsigned> servo_indices() const;
  friend bool operator==(const RobotModel&, const RobotModel&) = default;
};

}  // namespace eyebridge::robot
