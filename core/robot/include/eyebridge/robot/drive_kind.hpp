#pragma once

#include <span>
#include <vector>

namespace eyebridge::robot {

/// How wheels make a robot move. Motors and encoders count from 0, programs from 1.
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

/// What is to be known of a kind of drive without the numbers of a robot.
struct DriveFacts {
  DriveKind kind;
  const char* name;     ///< "differential"
  const char* keyword;  ///< In files of robots: "DIFFERENTIAL_DRIVE".
  std::vector<DrivePart> motors;
  std::vector<DrivePart> encoders;
};

/// The table of kinds, each once.
std::span<const DriveFacts> drive_kinds();
const DriveFacts& facts_of(DriveKind kind);

}  // namespace eyebridge::robot
