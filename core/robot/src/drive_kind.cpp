#include "eyebridge/robot/drive_kind.hpp"

#include <algorithm>

#include "chassis.hpp"

namespace eyebridge::robot {

// Each in the source that has its name.
ChassisMaker make_differential, make_ackermann, make_mecanum, make_swedish, make_synchro,
    make_submarine;

std::span<const DriveFacts> drive_kinds() {
  static const std::vector<DrivePart> kTwo = {{"left", "_LEFT"}, {"right", "_RIGHT"}};
  static const std::vector<DrivePart> kFour = {
      {"front left", "_FL"}, {"front right", "_FR"}, {"rear left", "_BL"}, {"rear right", "_BR"}};
  static const std::vector<DrivePart> kThree = {
      {"front left", "_LEFT"}, {"front right", "_RIGHT"}, {"rear", "_BACK"}};
  static const std::vector<DrivePart> kTurning = {{"drive", "_DRIVE"}, {"steer", "_TURN"}};
  static const std::vector<DrivePart> kThrusters = {
      {"left", "_LEFT"}, {"front", "_FRONT"}, {"right", "_RIGHT"}, {"back", "_BACK"}};
  static const std::vector<DriveFacts> kKinds = {{.kind = DriveKind::Differential,
                                                  .name = "differential",
                                                  .keyword = "DIFFERENTIAL_DRIVE",
                                                  .motors = kTwo,
                                                  .encoders = kTwo,
                                                  .make_chassis = make_differential,
                                                  .has_two_wheels = true},
                                                 {.kind = DriveKind::Ackermann,
                                                  .name = "ackermann",
                                                  .keyword = "ACKERMANN_DRIVE",
                                                  .motors = {{"drive", ""}},
                                                  .encoders = kTwo,
                                                  .make_chassis = make_ackermann,
                                                  .wheel_base_share = 0.0,
                                                  .steering = Steering::FrontWheels},
                                                 {.kind = DriveKind::Omni,
                                                  .name = "omni",
                                                  .keyword = "OMNI_DRIVE",
                                                  .motors = kFour,
                                                  .encoders = kFour,
                                                  .make_chassis = make_mecanum,
                                                  .axle_share = 0.5},
                                                 {.kind = DriveKind::Swedish,
                                                  .name = "swedish",
                                                  .keyword = "SWEDISH_DRIVE",
                                                  .motors = kThree,
                                                  .encoders = kThree,
                                                  .make_chassis = make_swedish},
                                                 {.kind = DriveKind::Synchro,
                                                  .name = "synchro",
                                                  .keyword = "SYNCHRO_DRIVE",
                                                  .motors = kTurning,
                                                  .encoders = kTurning,
                                                  .make_chassis = make_synchro,
                                                  .wheel_base_share = 0.0,
                                                  .steering = Steering::AllWheels},
                                                 {.kind = DriveKind::Submarine,
                                                  .name = "submarine",
                                                  .keyword = "SUBMARINE_DRIVE",
                                                  .motors = kThrusters,
                                                  .encoders = {},
                                                  .make_chassis = make_submarine,
                                                  .right_motor = 2,
                                                  .dives = true}};
  return kKinds;
}

const DriveFacts& facts_of(DriveKind kind) {
  return *std::ranges::find(drive_kinds(), kind, &DriveFacts::kind);
}

}  // namespace eyebridge::robot
