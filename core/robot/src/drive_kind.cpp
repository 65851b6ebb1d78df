#include "eyebridge/robot/drive_kind.hpp"

#include <algorithm>

namespace eyebridge::robot {

std::span<const DriveFacts> drive_kinds() {
  static const std::vector<DrivePart> kTwo = {{"left", "_LEFT"}, {"right", "_RIGHT"}};
  static const std::vector<DrivePart> kFour = {
      {"front left", "_FL"}, {"front right", "_FR"}, {"rear left", "_BL"}, {"rear right", "_BR"}};
  static const std::vector<DrivePart> kThree = {
      {"front left", "_LEFT"}, {"front right", "_RIGHT"}, {"rear", "_BACK"}};
  static const std::vector<DrivePart> kTurning = {{"drive", "_DRIVE"}, {"steer", "_TURN"}};
  static const std::vector<DriveFacts> kKinds = {
      {DriveKind::Differential, "differential", "DIFFERENTIAL_DRIVE", kTwo, kTwo},
      {DriveKind::Ackermann, "ackermann", "ACKERMANN_DRIVE", {{"drive", ""}}, kTwo},
      {DriveKind::Omni, "omni", "OMNI_DRIVE", kFour, kFour},
      {DriveKind::Swedish, "swedish", "SWEDISH_DRIVE", kThree, kThree},
      {DriveKind::Synchro, "synchro", "SYNCHRO_DRIVE", kTurning, kTurning},
      {DriveKind::Submarine,
       "submarine",
       "SUBMARINE_DRIVE",
       {{"left", "_LEFT"}, {"front", "_FRONT"}, {"right", "_RIGHT"}, {"back", "_BACK"}},
       {}}};
  return kKinds;
}

const DriveFacts& facts_of(DriveKind kind) {
  return *std::ranges::find(drive_kinds(), kind, &DriveFacts::kind);
}

}  // namespace eyebridge::robot
