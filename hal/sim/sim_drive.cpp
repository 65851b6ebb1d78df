#include "sim/sim_drive.hpp"

#include <fmt/format.h>

#include "arguments/arguments.hpp"

namespace eyebridge::hal {
namespace {

DriveProgress progress_of(robot::DriveState state) {
  switch (state) {
    case robot::DriveState::Idle:
      return DriveProgress::Done;
    case robot::DriveState::Driving:
      return DriveProgress::Driving;
    case robot::DriveState::Failed:
      return DriveProgress::Failed;
  }
  return DriveProgress::Failed;
}

}  // namespace

void SimDrive::look_for_repeats(const robot::Simulation& simulation) {
  const auto headings = repeats_.add(from_seconds(simulation.time()), simulation.pose(robot_));
  if (!headings) return;
  world_.warn(
      fmt::format("robot {} has stayed in one place for a minute and turned only to the same {} "
                  "headings: its program may never see anything new. Motion without errors repeats "
                  "exactly; try --errors realistic",
                  robot_ + 1, *headings));
}

Result<void> SimDrive::set_speed(const Twist& twist) {
  return check_speed(twist).map([&] {
    world_.locked([&](auto& sim) {
      look_for_repeats(sim);
      sim.set_speed(robot_, twist);
    });
  });
}

Result<void> SimDrive::start(const DriveGoal& goal) {
  return check_goal(goal).map([&] {
    world_.locked([&](auto& sim) {
      look_for_repeats(sim);
      sim.drive(robot_, goal);
    });
  });
}

Result<DriveStatus> SimDrive::status() {
  return world_.sensed([&](auto& sim) {
    const unsigned stalled = sim.stalled(robot_);
    return DriveStatus{progress_of(sim.drive_state(robot_)), sim.remaining(robot_),
                       (stalled & robot::kStallLeft) != 0, (stalled & robot::kStallRight) != 0};
  });
}

Result<Twist> SimDrive::measured_twist() {
  return world_.sensed([&](auto& sim) { return sim.measured_twist(robot_); });
}

Result<Pose> SimDrive::odometry() {
  return world_.sensed([&](auto& sim) { return sim.odometry(robot_); });
}

Result<void> SimDrive::set_odometry(const Pose& pose) {
  return check_pose(pose).map(
      [&] { world_.locked([&](auto& sim) { sim.set_odometry(robot_, pose); }); });
}

}  // namespace eyebridge::hal
