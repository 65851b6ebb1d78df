#include "eyebridge/robot/drive_kind.hpp"

#include <algorithm>

#include "chassis.hpp"

namespace eyebridge::robot {

// Each in the source that has its name.
ChassisMaker make_differential, make_ackermann, make_mecanum, make_swedish, make_synchro,
    make_submarine;

namespace {

constexpr DriveTraits kTwoWheels{.has_two_wheels = true};
constexpr DriveTraits kCar{.wheel_base_share = 0.0, .steering = Steering::FrontWheels};
constexpr DriveTraits kMecanum{.axle_share = 0.5};
constexpr DriveTraits kSteered{.wheel_base_share = 0.0, .steering = Steering::AllWheels};
constexpr DriveTraits kDiving{.right_motor = 2, .dives = true};

}  // namespace

std::span<const DriveFacts> drive_kinds() {
  static const std::vector<DrivePart> kTwo = {{"left", "_LEFT"}, {"right", "_RIGHT"}};
  static const std::vector<DrivePart> kFour = {
      {"front left", "_FL"}, {"front right", "_FR"}, {"rear left", "_BL"}, {"rear right", "_BR"}};
  static const std::vector<DrivePart> kThree = {
      {"front left", "_LEFT"}, {"front right", "_RIGHT"}, {"rear", "_BACK"}};
  static const std::vector<DrivePart> kTurning = {{"drive", "_DRIVE"}, {"steer", "_TURN"}};
  static const std::vector<DrivePart> kThrusters = {
      {"left", "_LEFT"}, {"front", "_FRONT"}, {"right", "_RIGHT"}, {"back", "_BACK"}};
  using enum DriveKind;
  static const DriveFacts kKinds[] = {
      {kTwoWheels, Differential, "differential", "DIFFERENTIAL_DRIVE", kTwo, kTwo,
       make_differential},
      {kCar, Ackermann, "ackermann", "ACKERMANN_DRIVE", {{"drive", ""}}, kTwo, make_ackermann},
      {kMecanum, Omni, "omni", "OMNI_DRIVE", kFour, kFour, make_mecanum},
      {DriveTraits{}, Swedish, "swedish", "SWEDISH_DRIVE", kThree, kThree, make_swedish},
      {kSteered, Synchro, "synchro", "SYNCHRO_DRIVE", kTurning, kTurning, make_synchro},
      {kDiving, Submarine, "submarine", "SUBMARINE_DRIVE", kThrusters, {}, make_submarine}};
  return kKinds;
}

const DriveFacts& facts_of(DriveKind kind) {
  return *std::ranges::find(drive_kinds(), kind, &DriveFacts::kind);
}

}  // namespace eyebridge::robot
