#include <ostream>
#include <string>
#include <vector>

#include "host_drive_plant.hpp"

// The measure of v-omega on the host: where the robot ends truly, against the same goals driven by
// the simulation's own controller, within 2 % of the path and 2 degrees.
namespace eyebridge::hal {
namespace {

struct Course {
  const char* name;
  std::vector<DriveGoal> goals;
};

const Course kCourses[] = {
    {"OneMetre", {{1.0, 0.0, 0.3}}},
    {"BackwardsSlowly", {{-0.4, 0.0, 0.05}}},
    {"AsFastAsItCan", {{3.0, 0.0, 9.0}}},
    {"ThreeCentimetres", {{0.03, 0.0, 0.1}}},
    {"QuarterTurn", {{0.0, kPi / 2, 1.5}}},
    {"TwoTurnsRight", {{0.0, -4 * kPi, 4.0}}},
    {"OneDegree", {{0.0, deg_to_rad(1), 0.5}}},
    {"GentleCurve", {{1.5, 1.0, 0.4}}},
    {"TightCurve", {{0.1, kPi, 0.3}}},
    {"BackwardsCurve", {{-0.8, 0.9, 0.3}}},
    {"Square",
     {{0.8, 0.0, 0.3},
      {0.0, kPi / 2, 1.5},
      {0.8, 0.0, 0.3},
      {0.0, kPi / 2, 1.5},
      {0.8, 0.0, 0.3},
      {0.0, kPi / 2, 1.5},
      {0.8, 0.0, 0.3},
      {0.0, kPi / 2, 1.5}}},
    {"FigureOfEight", {{2.0, 2 * kPi, 0.35}, {2.0, -2 * kPi, 0.35}}},
};

struct Wheels {
  const char* name;
  double time_constant;
  bool host_knows_it;
};
const Wheels kWheels[] = {
    {"Exact", 0.0, true}, {"Lagging", 0.06, true}, {"LaggingUnknown", 0.06, false}};

struct PoseCase {
  Course course;
  Wheels wheels;
};
void PrintTo(const PoseCase& tested, std::ostream* out) {
  *out << tested.course.name << " " << tested.wheels.name;
}

std::vector<PoseCase> all_cases() {
  std::vector<PoseCase> out;
  for (const Course& course : kCourses) {
    for (const Wheels& wheels : kWheels) out.push_back({course, wheels});
  }
  return out;
}

class HostDrivePose : public testing::TestWithParam<PoseCase> {};

TEST_P(HostDrivePose, EndsWhereTheSimulatedDriveEnds) {
  const robot::RobotModel model = plant_model(GetParam().wheels.time_constant);
  HostDriveSettings settings = plant_settings(model);
  if (!GetParam().wheels.host_knows_it) settings.motor_lag = 0.0;
  Plant plant(model, settings);
  Plant reference(model);
  double way = 0.0;
  double turn = 0.0;
  for (const DriveGoal& goal : GetParam().course.goals) {
    plant.drive.start(goal);
    plant.finish();
    EXPECT_EQ(plant.drive.status().progress, DriveProgress::Done);
    reference.sim.drive(reference.robot, goal);
    while (reference.sim.drive_state(reference.robot) == robot::DriveState::Driving) {
      reference.sim.step();
    }
    for (int i = 0; i < 50; ++i) reference.sim.step();
    way += std::abs(goal.distance);
    turn += std::abs(goal.angle);
  }
  const Pose is = plant.sim.pose(plant.robot);
  const Pose should = reference.sim.pose(reference.robot);
  const double apart = norm(is.position() - should.position());
  const double turned = std::abs(wrap_angle(is.theta - should.theta));
  RecordProperty("percent", std::to_string(way > 0 ? 100 * apart / way : 0));
  RecordProperty("degrees", std::to_string(rad_to_deg(turned)));
  // A lag that nobody told the host of lets the wheels roll on by a millimetre, however short the
  // way.
  const double roll = GetParam().wheels.host_knows_it ? 1e-4 : 1e-3;
  EXPECT_LE(apart, 0.02 * way + roll) << "of " << way << " m";
  EXPECT_LE(turned, deg_to_rad(2.0)) << "of " << rad_to_deg(turn) << " degrees";
  // What the program reads of it is what its encoders say, to a tick or two.
  const Pose read = plant.drive.odometry();
  EXPECT_NEAR(read.x, is.x - kPlantRoom / 2, 0.002 + 0.002 * way);
  EXPECT_NEAR(read.y, is.y - kPlantRoom / 2, 0.002 + 0.002 * way);
  EXPECT_NEAR(wrap_angle(read.theta - is.theta), 0.0, deg_to_rad(0.3));
}

INSTANTIATE_TEST_SUITE_P(HostDrive, HostDrivePose, testing::ValuesIn(all_cases()),
                         [](const auto& tested) {
                           return std::string(tested.param.course.name) + tested.param.wheels.name;
                         });

}  // namespace
}  // namespace eyebridge::hal
