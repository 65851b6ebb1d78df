#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/robot/lidar_presets.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

std::vector<Warning> robi_warnings;

robot::RobotModel robi_of(const std::string& text) {
  robi_warnings.clear();
  return read_robi(text, "r.robi", robi_warnings);
}

std::string robi_error(const std::string& text) {
  return error_of([&] { robi_of(text); });
}

TEST(Robi, ReadsTheOldDialect) {
  const auto robot = robi_of(
      "name My Bot \t# best\ndiameter 200\nspeed 500\nturn 90\n"
      "psd PSD_LEFT 2 56 45 30 90\ncamera 62 0 60 0 -5 80 60\n"
      "wheel 54 3600 1100 90\ndrive DIFFERENTIAL_DRIVE MOTOR_LEFT QUAD_LEFT\n"
      "this line is prose\n");
  EXPECT_EQ(robot.name, "My Bot");
  EXPECT_EQ(robot.diameter, 0.2);
  EXPECT_EQ(robot.drive.max_linear, 0.5);
  EXPECT_EQ(robot.drive.max_angular, kPi / 2);
  EXPECT_EQ(robot.drive.wheel_base, 0.09);
  EXPECT_EQ(robot.drive.ticks_per_revolution, 1100);
  ASSERT_EQ(robot.range_sensors.size(), 1u);
  EXPECT_EQ(robot.range_sensors[0].id, 2);
  EXPECT_EQ(robot.range_sensors[0].pose_in_robot, (Pose{0.056, 0.045, kPi / 2}));
  EXPECT_EQ(robot.range_sensors[0].height, 0.03);
  ASSERT_TRUE(robot.camera);
  EXPECT_EQ(robot.camera->tilt, deg_to_rad(-5));
  EXPECT_EQ(robot.camera->max_pan, deg_to_rad(90));  // 80 x 60 is the size of a picture
  EXPECT_EQ(robi_warnings.size(), 1u) << "of the prose";
}

TEST(Robi, ReadsRangeMatrices) {
  const auto robot = robi_of(
      "diameter 100\ntof 2 TOF_LEFT 10 20 55 90\ntof 1 TOF_FRONT 45 0 60 0 12 2500\n"
      "error tof 10 2 dropout=5\nerror tof:2 bias=3\n");
  EXPECT_TRUE(robi_warnings.empty());
  ASSERT_EQ(robot.range_matrices.size(), 2u);
  const robot::RangeMatrixModel& left = robot.range_matrices[0];
  EXPECT_EQ(left.id, 2);
  EXPECT_EQ(left.name, "TOF_LEFT");
  EXPECT_EQ(left.pose_in_robot, (Pose{0.01, 0.02, kPi / 2}));
  EXPECT_EQ(left.height, 0.055);
  EXPECT_EQ(left.tilt, 0.0);
  EXPECT_EQ(left.max_range, 4.0);
  EXPECT_EQ(left.error, (robot::RangeMatrixError{{{0.003, 0.01, 0.02}, 0.05}}));
  const robot::RangeMatrixModel& front = robot.range_matrices[1];
  EXPECT_EQ(front.tilt, deg_to_rad(12));
  EXPECT_EQ(front.max_range, 2.5);
  EXPECT_EQ(front.error.bias, 0.0);
  EXPECT_THAT(robi_error("diameter 99\ntof 1 A 0 0 0 0\ntof 1 B 0 0 0 0\n"),
              testing::HasSubstr("a second tof of this number"));
  EXPECT_THAT(robi_error("diameter 99\ntof 9 A 0 0 0 0\n"), testing::HasSubstr("1 to 8"));
  EXPECT_THAT(robi_error("diameter 99\ntof 1 A 0 0 0 0 61\n"), testing::HasSubstr("-60 to 60"));
  EXPECT_THAT(robi_error("diameter 99\ntof 1 A 0 0\n"),
              testing::HasSubstr("tof id NAME x y z angle [tilt [range]]"));
}

TEST(Robi, ReadsTheNewDialect) {
  const auto robot = robi_of(
      "drive DIFFERENTIAL_DRIVE\nname \"S 4\"\nmass 50 0 30 -30\n"
      "collider box 60 74 80 0 46 0\naxis 22.7 10.8\n"
      "psd 2 PSD_LEFT 10 20 30 0 90 0\ncamera 62 0 60 0 0 45 30\nfisheye 120\n"
      "wheel 54 3600 1100 45\nlidar 180 -10\n");
  EXPECT_EQ(robot.name, "S 4");
  EXPECT_NEAR(robot.diameter, 0.1, 1e-12);  // a 60 x 80 rectangle's diagonal
  EXPECT_EQ(robot.drive.wheel_base, 0.09);  // this dialect gives the half
  EXPECT_EQ(robot.drive.max_wheel_speed, deg_to_rad(3600));
  EXPECT_NEAR(robot.drive.max_linear, 20 * kPi * 0.027, 1e-12);
  EXPECT_EQ(robot.range_sensors.at(0).pose_in_robot, (Pose{0.03, -0.01, kPi / 2}));
  EXPECT_EQ(robot.range_sensors.at(0).height, 0.02);
  EXPECT_EQ(robot.camera->max_tilt, deg_to_rad(30));
  EXPECT_EQ(robot.camera->horizontal_field_of_view, deg_to_rad(120));
  EXPECT_EQ(robot.lidar->points, 180);
  EXPECT_EQ(robot.lidar->tilt, deg_to_rad(-10));
  EXPECT_TRUE(robi_warnings.empty());
}

TEST(Robi, NegativeAndMissingIdsBecomeThoseOfPrograms) {
  const auto robot = robi_of(
      "name X\ndiameter 100\npsd PSD_BACK -212 -40 0 0 180\n"
      "psd PSD_DIAG -203 5 8 0 0\npsd PSD_FRONT 60 20 30 0\n");
  EXPECT_EQ(robot.range_sensors.at(0).id, 4);
  EXPECT_EQ(robot.range_sensors.at(1).id, 5);
  EXPECT_EQ(robot.range_sensors.at(2).id, 1);
  ASSERT_EQ(robi_warnings.size(), 1u);
  EXPECT_THAT(robi_warnings[0].text,
              testing::HasSubstr("PSD_BACK = 4, PSD_DIAG = 5, PSD_FRONT = 1"));
}

TEST(Robi, ReadsThrowsOfServosAsPanAndTilt) {
  const auto robot = robi_of("diameter 9\ncamera 45 0 72 SERVO1(-90,+90) SERVO2(-95,+85) 80 60\n");
  EXPECT_EQ(robot.camera->pan, 0);
  EXPECT_EQ(robot.camera->max_pan, deg_to_rad(90));
  EXPECT_EQ(robot.camera->tilt, deg_to_rad(-5));
  EXPECT_EQ(robot.camera->max_tilt, deg_to_rad(90));
}

TEST(Robi, AckermannTakesItsDrivenWheels) {
  const auto robot = robi_of(
      "drive ACKERMANN_DRIVE\naxel drive 22.7 -94\naxel turn 12 66\n"
      "wheel drive 40 7200 640 44.5\nwheel turn 28 7200 640 40\n");
  EXPECT_EQ(robot.drive.kind, robot::DriveKind::Ackermann);
  EXPECT_EQ(robot.drive.wheel_diameter, 0.04);
  EXPECT_EQ(robot.drive.wheel_base, 0.089);
  EXPECT_EQ(robot.diameter, 0.178);  // no collider: twice the wheel base
  EXPECT_EQ(robot.drive.rear_axle, -0.094);
  EXPECT_NEAR(robot.drive.axle_distance, 0.16, 1e-15);
  // As far as EyeSim's cars steer, and what that makes of the top speed.
  EXPECT_EQ(robot.drive.max_steering, deg_to_rad(45));
  EXPECT_EQ(robot.drive.steering_servo, 0u);
  EXPECT_NEAR(robot.drive.max_angular, robot.drive.max_linear / 0.16, 1e-12);
  EXPECT_TRUE(robi_warnings.empty());
}

TEST(Robi, SteeringSaysHowFarByWhichServoAndHowFast) {
  const std::string car = "drive ACKERMANN_DRIVE\naxles 200\nwheel 40 7200 640 50\n";
  const auto limited = robi_of(car + "steering 30\n");
  EXPECT_EQ(limited.drive.max_steering, deg_to_rad(30));
  EXPECT_EQ(limited.drive.steering_speed, 0.0);
  EXPECT_EQ(limited.drive.axle_distance, 0.2);
  const auto all = robi_of(car + "steering 25 3 200\n");
  EXPECT_EQ(all.drive.steering_servo, 2u);
  EXPECT_EQ(all.drive.steering_speed, deg_to_rad(200));
  EXPECT_TRUE(robi_warnings.empty());
  robi_of("drive ACKERMANN_DRIVE\nwheel 40 7200 640 50\n");
  ASSERT_EQ(robi_warnings.size(), 1u);
  EXPECT_THAT(robi_warnings[0].str(), testing::StartsWith("r.robi:1:1: warning: neither 'axel"));
}

TEST(Robi, KindsOfDriveTurnAsFastAsTheirWheelsCan) {
  const std::string wheel = "diameter 300\nwheel 100 360 5000 200\n";
  const double rim = 0.05 * 2 * kPi;
  const auto square = robi_of(wheel + "drive OMNI_DRIVE MOTOR_FL QUAD_FL\n");
  EXPECT_EQ(square.drive.kind, robot::DriveKind::Omni);
  EXPECT_EQ(square.drive.axle_distance, 0.2);  // as nothing else is said
  EXPECT_NEAR(square.drive.max_angular, rim / 0.2, 1e-12);
  const auto longer = robi_of(wheel + "axles 300\ndrive OMNI_DRIVE\n");
  EXPECT_NEAR(longer.drive.max_angular, rim / 0.25, 1e-12);
  const auto three = robi_of(wheel + "drive SWEDISH_DRIVE\n");
  EXPECT_EQ(three.drive.kind, robot::DriveKind::Swedish);
  EXPECT_NEAR(three.drive.max_angular, rim / 0.1, 1e-12);
  const auto synchro = robi_of(wheel + "drive SYNCHRO_DRIVE\n");
  EXPECT_EQ(synchro.drive.kind, robot::DriveKind::Synchro);
  EXPECT_EQ(synchro.drive.max_angular, robot::DriveModel{}.max_angular);
}

TEST(Robi, ASubmarineHasThrustersAndDives) {
  const auto robot = robi_of(
      "drive SUBMARINE_DRIVE\nspeed 600\nturn 90\ndive 200 -15 1.5\naccel 300 40\n"
      "diameter 800\ncollider box 300 250 800 0 125 0\n");
  const robot::DriveModel& drive = robot.drive;
  EXPECT_EQ(drive.kind, robot::DriveKind::Submarine);
  EXPECT_EQ(drive.max_linear, 0.6);
  EXPECT_EQ(drive.max_angular, kPi / 2);
  EXPECT_EQ(drive.max_vertical, 0.2);
  EXPECT_EQ(drive.rise_speed, -0.015);
  EXPECT_EQ(drive.motor_time_constant, 1.5);
  EXPECT_EQ(drive.linear_acceleration, 0.3);
  EXPECT_EQ(robot.height, 0.25);
  // Both thrusters together reach the speed, against each other the turn.
  const double rim = drive.max_wheel_speed * drive.wheel_diameter / 2;
  EXPECT_NEAR(rim, 0.6, 1e-15);
  EXPECT_NEAR(2 * rim / drive.wheel_base, kPi / 2, 1e-15);
  EXPECT_TRUE(robi_warnings.empty());
}

TEST(Robi, MistakesAboutSubmarinesAreNamed) {
  EXPECT_EQ(robi_error("dive 200 20"),
            "r.robi:1:12: 'dive' with 2 arguments: expected 'dive mm_per_second "
            "rise_mm_per_second glide_seconds'");
  EXPECT_EQ(robi_error("dive 0 20 1"), "r.robi:1:6: the vertical speed is 0: expected 1 to 100000");
  EXPECT_EQ(robi_error("dive 200 20 0"),
            "r.robi:1:13: the time constant of its drag in seconds is 0: expected 0.01 to 1000");
  EXPECT_EQ(robi_error("name A\n dive 200 20 1"),
            "r.robi:2:2: dive without thrusters: expected SUBMARINE_DRIVE");
  EXPECT_EQ(robi_error("div 200 20 1"), "r.robi:1:1: unknown keyword 'div': expected 'dive'?");
  const auto robot =
      robi_of("name A\ndiameter 9\ndrive SUBMARINE_DRIVE\nwheel 1 2 3 4\nspeed 100\n");
  EXPECT_EQ(robot.drive.max_linear, 0.1);
  EXPECT_EQ(robot.drive.max_angular, deg_to_rad(45));
  EXPECT_EQ(robot.drive.max_vertical, 0.25);
  ASSERT_EQ(robi_warnings.size(), 2u);
  EXPECT_EQ(robi_warnings[0].str(),
            "r.robi:3:1: warning: a submarine has no wheels: its 'wheel' is not used");
  EXPECT_THAT(robi_warnings[1].str(),
              testing::StartsWith("r.robi:3:1: warning: a submarine needs 'speed', "));
}

TEST(Robi, ReadsOurExtensionsAndAppliesThemToEarlierLines) {
  const auto robot = robi_of(
      "error psd 4 2\ndiameter 99\npsd A 1 0 0 0 0\npsd_range 50 800\n"
      "ir I 1 80 0 20 0 120\nbump B 1 -45 45\naccel 800 90\ncamera 1 2 3 4 5\n"
      "lidar 9 0\nerror drive 3 4\nerror wheels 1 -2\nerror encoder quantised\n"
      "error compass 90\nerror camera 5 6\nerror ir 7\nerror bump 8\nerror radio 9 250\n"
      "error lidar 9 10\n");
  EXPECT_EQ(robot.range_sensors[0].error.sigma, 0.004);
  EXPECT_EQ(robot.range_sensors[0].error.sigma_relative, 0.02);
  EXPECT_EQ(robot.range_sensors[0].min_range, 0.05);
  EXPECT_EQ(robot.range_sensors[0].max_range, 0.8);
  EXPECT_EQ(robot.proximity_sensors.at(0).threshold, 0.12);
  EXPECT_EQ(robot.proximity_sensors.at(0).error.flip, 0.07);
  EXPECT_EQ(robot.bumpers.at(0).start, -kPi / 4);
  EXPECT_EQ(robot.bumpers.at(0).error.miss, 0.08);
  EXPECT_EQ(robot.drive.linear_acceleration, 0.8);
  EXPECT_EQ(robot.drive.angular_acceleration, kPi / 2);
  EXPECT_EQ(robot.drive_error, (robot::DriveError{0.03, 0.04, 0.01, -0.02, 1}));
  EXPECT_EQ(robot.compass_error.sigma, kPi / 2);
  EXPECT_EQ(robot.camera->error.salt_and_pepper, 0.05);
  EXPECT_EQ(robot.radio_error.loss, 0.09);
  EXPECT_EQ(robot.radio_error.delay, 0.25);
  EXPECT_EQ(robot.camera->error.sigma, 6);
  EXPECT_EQ(robot.lidar->error.sigma, 0.009);
  EXPECT_EQ(robot.lidar->error.sigma_relative, 0.1);
}

TEST(Robi, ReadsAKicker) {
  const auto robot = robi_of("diameter 100\nkicker 3 1500 30 25\n");
  EXPECT_EQ(robot.kicker, (robot::KickerModel{2, 1.5, 0.03, deg_to_rad(25)}));
  EXPECT_EQ(robi_of("diameter 100\nkicker 16 1 0\n").kicker->half_angle, deg_to_rad(20));
  EXPECT_FALSE(robi_of("diameter 100\n").kicker);
  EXPECT_EQ(robi_of("diameter 100\nfriction 0.5\n").contact_friction, 0.5);
}

TEST(Robi, MistakesAboutAKickerAreNamed) {
  EXPECT_EQ(robi_error("kicker 3 1500"),
            "r.robi:1:14: 'kicker' with 2 arguments: expected 'kicker servo mm_per_second reach_mm "
            "[half_angle]'");
  EXPECT_EQ(robi_error("kicker 2 1500 30"),
            "r.robi:1:8: the servo (1 and 2 are the camera's) is 2: expected 3 to 16");
  EXPECT_EQ(robi_error("kicker 3 0 30"), "r.robi:1:10: the ball's speed is 0: expected 1 to 20000");
  EXPECT_EQ(robi_error("kicker 3 1 30\nkicker 4 1 30"),
            "r.robi:2:1: a second kicker: expected one");
}

TEST(Robi, ReadsServosThatTurnWheels) {
  using Wheel = robot::ServoModel::Wheel;
  const auto robot =
      robi_of("diameter 100\nservo 12 SERVO_LEFT left\nservo 13 SERVO_RIGHT Right\nservo 7 ARM\n");
  EXPECT_EQ(robot.servos, (std::vector<robot::ServoModel>{{11, "SERVO_LEFT", Wheel::Left},
                                                          {12, "SERVO_RIGHT", Wheel::Right},
                                                          {6, "ARM", Wheel::None}}));
  EXPECT_EQ(robot.servo_indices(), (std::vector<unsigned>{0, 1, 6, 11, 12}));
}

TEST(Robi, MistakesAboutServosAreNamed) {
  EXPECT_EQ(robi_error("servo 3"),
            "r.robi:1:8: 'servo' with 1 argument: expected 'servo number NAME [left|right]'");
  EXPECT_EQ(robi_error("servo 2 PAN"),
            "r.robi:1:7: the servo (1 and 2 are the camera's) is 2: expected 3 to 16");
  EXPECT_EQ(robi_error("servo 12 L front"),
            "r.robi:1:12: 'front' found: expected the wheel that it turns, left or right");
  EXPECT_EQ(robi_error("servo 12 L left\nservo 12 R right"),
            "r.robi:2:7: a second servo of this number: expected one");
  EXPECT_EQ(robi_error("servo 12 L left\nservo 13 R left"),
            "r.robi:2:12: a second servo for this wheel: expected one");
  EXPECT_EQ(robi_error("servo 3 ARM\nkicker 3 1 30"),
            "r.robi:1:7: servo 3 kicks already: expected another one");
  EXPECT_EQ(robi_error("servo 3 ARM\ndrive ACKERMANN_DRIVE\nsteering 30 3"),
            "r.robi:1:7: servo 3 steers already: expected another one");
  EXPECT_EQ(robi_error("servo 3 ARM left\ndrive OMNI_DRIVE"),
            "r.robi:1:7: servo 3 turns a wheel: expected a DIFFERENTIAL_DRIVE for that");
}

TEST(Robi, ErrorsAreOffUnlessAskedFor) {
  const auto robot = robi_of("diameter 99\npsd A 1 0 0 0 0\n");
  EXPECT_TRUE(robot.range_sensors[0].error.perfect());
  EXPECT_EQ(robot.drive_error, robot::DriveError{});
}

TEST(Robi, ALikelyTypoOfAKeywordIsAnErrorInBothDialects) {
  EXPECT_EQ(robi_error("diameter 99\n speeed 600\n"),
            "r.robi:2:2: unknown keyword 'speeed': expected 'speed'?");
  EXPECT_EQ(robi_error("drive DIFFERENTIAL_DRIVE\ndiametre 99\n"),
            "r.robi:2:1: unknown keyword 'diametre': expected 'diameter'?");
}

TEST(Robi, OtherUnknownLinesAreCommentsOrWarnedOf) {
  robi_of("diameter 99\nanything else\nand more\n");
  ASSERT_EQ(robi_warnings.size(), 1u);
  EXPECT_EQ(robi_warnings[0].str(),
            "r.robi:2:1: warning: 2 lines that begin with no keyword are left out, this is the "
            "first: '#' begins a comment");
  robi_of("drive DIFFERENTIAL_DRIVE\nanything else\n");
  ASSERT_FALSE(robi_warnings.empty());
  EXPECT_EQ(robi_warnings[0].str(), "r.robi:2:1: warning: unknown keyword 'anything' is ignored");
}

TEST(Robi, EveryMistakeIsNamedWithItsPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"psd A 1 0 0 0 0\npsd B 1 0 0 0 0",
       "r.robi:2:7: psd id 1 is given twice: expected every id "
       "once"},
      {"psd A 0 0 0 0 0", "r.robi:1:7: id 0 found: expected 1 or more"},
      {"psd A 1.5 0 0 0 0", "r.robi:1:7: '1.5' found: expected the id, a whole number"},
      {"drive HOVERCRAFT",
       "r.robi:1:7: unknown drive 'HOVERCRAFT': expected DIFFERENTIAL_DRIVE, "
       "ACKERMANN_DRIVE, OMNI_DRIVE, SWEDISH_DRIVE, SYNCHRO_DRIVE or SUBMARINE_DRIVE"},
      {"drive OMNI_DRIVE\nsteering 30",
       "r.robi:2:1: steering without front wheels: expected ACKERMANN_DRIVE"},
      {"drive ACKERMANN_DRIVE\nsteering 90",
       "r.robi:2:10: the most that the wheels turn is 90: expected 1 to 80"},
      {"drive ACKERMANN_DRIVE\nsteering 30 17", "r.robi:2:13: the servo is 17: expected 1 to 16"},
      {"drive ACKERMANN_DRIVE\nsteering 30 3\nkicker 3 1 30",
       "r.robi:2:13: servo 3 kicks already: expected another one to steer"},
      {"drive ACKERMANN_DRIVE\naxel drive 0 5\naxel turn 0 5",
       "r.robi:3:13: the front axle is not before the rear one: expected 'axel turn' ahead of "
       "'axel drive'"},
      {"axel middle 0 5", "r.robi:1:6: 'middle' found: expected 'drive' or 'turn'"},
      {"axles 0", "r.robi:1:7: the distance between the axles is 0: expected 1 to 10000"},
      {"error psi 1 2", "r.robi:1:7: unknown error model 'psi': expected 'psd'?"},
      {"error encoder rounded", "r.robi:1:15: 'rounded' found: expected quantised or miss"},
      {"diameter -5", "r.robi:1:10: the diameter is -5: expected 1 to 10000"},
      {"diameter nan", "r.robi:1:10: 'nan' found: expected the diameter, a number"},
      {"name R\n fisheye 100", "r.robi:2:2: fisheye without camera: expected a 'camera' line"},
      {"psd_range 80 20", "r.robi:1:14: the longest range is not above the shortest"},
      {"collider cone 1", "r.robi:1:10: 'cone' found: expected box, sphere or capsule"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(robi_error(text), expected) << text;
  EXPECT_THAT(robi_error(""), testing::HasSubstr("no keyword of a robot description"));
  EXPECT_THAT(robi_error("once upon a time"),
              testing::HasSubstr("no keyword of a robot description"));
}

TEST(Robi, GivesDistanceSensorsTheirKinds) {
  const auto robot = robi_of(
      "psd_kind infrared 100 800\npsd_kind ray:3\npsd_kind Ultrasound:2 30 25 50 4000\n"
      "psd_kind ultrasound:7 20 90\npsd_kind down:8\npsd_range 20 900\ndiameter 99\n"
      "psd A 1 0 0 0 0\npsd B 2 0 0 0 0\npsd C 3 0 0 0 0\npsd D 7 0 0 0 0\npsd E 8 0 0 5 0\n");
  const auto& psds = robot.range_sensors;
  EXPECT_EQ(psds[0].kind, robot::RangeKind::Infrared);
  EXPECT_EQ(psds[0].min_range, 0.1);
  EXPECT_EQ(psds[0].max_range, 0.8);
  EXPECT_EQ(psds[1].kind, robot::RangeKind::Ultrasound);
  EXPECT_EQ(psds[1].ultrasound, (robot::UltrasoundModel{deg_to_rad(30), deg_to_rad(25)}));
  EXPECT_EQ(psds[1].min_range, 0.05);
  EXPECT_EQ(psds[1].max_range, 4.0);
  EXPECT_EQ(psds[2].kind, robot::RangeKind::Ray) << "the later line";
  EXPECT_EQ(psds[3].kind, robot::RangeKind::Ultrasound);
  EXPECT_EQ(psds[3].ultrasound.critical_angle, deg_to_rad(90));
  EXPECT_EQ(psds[3].max_range, 0.8) << "as the first line says of all";
  EXPECT_EQ(psds[4].kind, robot::RangeKind::Down);
  EXPECT_EQ(psds[4].height, 0.005);
  EXPECT_TRUE(robi_warnings.empty());
}

TEST(Robi, MistakesAboutKindsHaveTheirPlace) {
  const std::string psds = "diameter 99\npsd A 1 0 0 0 0\npsd B 4 0 0 0 0\n";
  const std::pair<const char*, const char*> cases[] = {
      {"psd_kind", "r.robi:4:9: line ends: expected ray, ultrasound, infrared or down"},
      {"psd_kind sonar",
       "r.robi:4:10: unknown kind of psd 'sonar': expected ray, ultrasound, infrared or down"},
      {"psd_kind infrard 1 2", "r.robi:4:10: unknown kind of psd 'infrard': expected 'infrared'?"},
      {"psd_kind ray:0", "r.robi:4:10: '0' found: expected the number of a psd, 1 or more"},
      {"psd_kind ray:", "r.robi:4:10: '' found: expected the number of a psd, 1 or more"},
      {"psd_kind ray:3", "r.robi:4:10: robot 'S4' has no psd 3: expected one of 1, 4"},
      {"psd_kind ultrasound 181 25",
       "r.robi:4:21: the width of the beam is 181: expected 0 to 180"},
      {"psd_kind ultrasound 30 91", "r.robi:4:24: the critical angle is 91: expected 0 to 90"},
      {"psd_kind infrared 800 100", "r.robi:4:23: the longest range is not above the shortest"},
      {"psd_kind down:4 9",
       "r.robi:4:17: 'psd_kind' with 2 arguments: expected 'psd_kind down[:ID]'"},
  };
  for (const auto& [line, expected] : cases) EXPECT_EQ(robi_error(psds + line), expected) << line;
  EXPECT_EQ(robi_error("diameter 99\npsd_kind ray:1\n"),
            "r.robi:2:10: robot 'S4' has no psd 1: expected a psd line, it has none");
  EXPECT_THAT(robi_error(psds + "psd_kind ultrasound 30"),
              testing::HasSubstr("psd_kind ultrasound[:ID] beam_deg critical_deg min_mm max_mm"));
}

TEST(Robi, ALidarMayBeOneThatIsSold) {
  const auto robot = robi_of("diameter 99\nlidar lms200 -5\nerror lidar bias=4\n");
  ASSERT_TRUE(robot.lidar);
  EXPECT_EQ(robot.lidar->points, 361);
  EXPECT_EQ(robot.lidar->field_of_view, kPi);
  EXPECT_EQ(robot.lidar->max_range, 8.0);
  EXPECT_EQ(robot.lidar->tilt, deg_to_rad(-5));
  EXPECT_EQ(robot.lidar->error, (robot::LidarError{{0.004, 0.005, 0.0}, 0.0}));
  for (const std::string_view name : robot::kLidarPresets) {
    EXPECT_EQ(robi_of("diameter 99\nlidar " + std::string(name)).lidar, robot::lidar_preset(name));
  }
  EXPECT_EQ(robi_error("diameter 99\nlidar many 0\n"),
            "r.robi:2:7: 'many' found: expected the number of points, or LMS200, LMS200-1, "
            "URG-04LX or RPLIDAR-A1");
  EXPECT_THAT(robi_error("diameter 99\nlidar LMS200 0 8000\n"),
              testing::HasSubstr("lidar LMS200 [tilt]"));
}

}  // namespace
}  // namespace eyebridge::files
