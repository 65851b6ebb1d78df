#pragma once

#include <memory>
#include <span>
#include <vector>

namespace eyebridge::robot {

class Chassis;
struct MotorModel;
struct RobotModel;

/// How wheels make a robot move. Motors and encoders count from 0, programs from 1. What is to be
/// known of a kind stands in its DriveFacts: nothing else asks which one it is.
enum class DriveKind {
  Differential,  ///< Motor and encoder 0 left, 1 right.
  Ackermann,     ///< As a car: motor 0 drives both rear wheels through a differential gear, a servo
                 ///< steers the front ones. Encoders: rear wheels, 0 left, 1 right.
  Omni,          ///< Four mecanum wheels: 0 front left, 1 front right, 2 back left, 3 back right.
  Swedish,       ///< Three omnidirectional wheels about the centre, 120 degrees apart: 0 left front
                 ///< (at 60 degrees), 1 right front, 2 back. 0 and 1 drive it forward, 2 takes the
                 ///< back to the right: 0 backward, 1 and 2 forward turn it to the left.
  Synchro,    ///< All wheels roll by motor 0 and are steered by motor 1, together; the body keeps
              ///< its heading. Odometry's heading is where the wheels point.
  Submarine,  ///< Four thrusters in water: 0 left and 2 right push forward, 1 front and 3 back push
              ///< up. No encoders. 1 and 3 run beside v-omega driving, which has 0 and 2.
};

/// What a motor or an encoder of a drive is called.
struct DrivePart {
  const char* name;    ///< In words: "front left".
  const char* suffix;  ///< In EyeSim's files, behind MOTOR or QUAD: "_FL".
};

/// Which wheels of a drive point where they are steered to.
enum class Steering {
  None,
  FrontWheels,  ///< By a servo: no turn without a way, and no curve sharper than they allow.
  AllWheels,    ///< By a motor.
};

/// What is special about a kind of drive; most have two wheels or more that turn the robot.
struct DriveTraits {
  /// Nothing but a left and a right wheel with a motor each: what boards, servos that turn wheels
  /// and actions for two motors need.
  bool has_two_wheels = false;
  unsigned right_motor = 1;  ///< Which does on the right what motor 0 does on the left.
  /// A turn takes these shares of DriveModel::wheel_base and axle_distance, metres a radian, from
  /// the speed of a wheel's rim; none where the steering does it.
  double wheel_base_share = 0.5;
  double axle_share = 0.0;
  Steering steering = Steering::None;
  bool dives = false;  ///< Moves in water, by thrusters.

  [[nodiscard]] bool steers_front() const { return steering == Steering::FrontWheels; }
};

/// What is to be known of a kind of drive without the numbers of a robot.
struct DriveFacts : DriveTraits {
  DriveKind kind;
  const char* name;     ///< "differential"
  const char* keyword;  ///< In files of robots: "DIFFERENTIAL_DRIVE".
  std::vector<DrivePart> motors;
  std::vector<DrivePart> encoders;
  /// Makes its chassis, in water of the depth `water`, metres. Throws std::invalid_argument when
  /// the model cannot be.
  std::unique_ptr<Chassis> (*make_chassis)(const RobotModel& robot, const MotorModel& motor,
                                           double water);
};

/// The table of kinds, each once.
std::span<const DriveFacts> drive_kinds();
const DriveFacts& facts_of(DriveKind kind);

}  // namespace eyebridge::robot
