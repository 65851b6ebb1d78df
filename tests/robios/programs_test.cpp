// Real programs, compiled against eyebot.h, run as users run them: the C API from outside.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::run_named;
using testing::ScratchFolder;

TEST(Programs, ATextBookProgramDrivesSeesAndShows) {
  const ProgramRun r = run_named("textbook", {{"EYEBRIDGE_KEYS", "KEY1@1s,KEY2@2s,KEY4@60s"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_THAT(r.out, HasSubstr("key 1\n"));
  // The robot of the default world stands at (1, 1) m; after 300 mm and a left turn the north wall
  // is 1000 mm from its centre, less the sensor's place on the robot.
  EXPECT_THAT(r.out, HasSubstr("at 300 0 90, wall ahead at 9"));
  EXPECT_THAT(r.out, HasSubstr("edges: some\n"));
  EXPECT_THAT(r.out, HasSubstr("size 320 240 76800 230400\n"));
}

TEST(Programs, ClocksAndTimersFollowVirtualTimeExactly) {
  const ProgramRun r = run_named("clocks");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("waited 1500\n"));
  EXPECT_THAT(r.out, HasSubstr("handles differ\n"));
  EXPECT_THAT(r.out, HasSubstr("fast 100 slow 6\n"));
  EXPECT_THAT(r.out, HasSubstr("late 5\n"));
  EXPECT_THAT(r.out, HasSubstr("detach twice 1, bad timer 0\n"));
  EXPECT_THAT(r.out, HasSubstr("time 00:00:03\n"));
}

TEST(Programs, SettingWhatWasReadChangesNothing) {
  const ProgramRun r = run_named("sim_calls");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("identity 1\n"));
  EXPECT_THAT(r.out, HasSubstr("robots 1 objects 0\n"));
  EXPECT_THAT(r.out, HasSubstr("unknown 1 1\nzeros 0 0 0\n"));
  EXPECT_THAT(r.out, HasSubstr("odometry 0 0 0\n"));
}

TEST(Programs, SensorsReadWhatGeometrySays) {
  const ProgramRun r = run_named("sensors");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("no such psd -1: PSDGet: this robot has no PSD 42\n"));
  EXPECT_THAT(r.out, HasSubstr("lidar 495 995 1495 995\n"));
  EXPECT_THAT(r.out, HasSubstr("part 995 1495 995\n"));
  EXPECT_THAT(r.out, HasSubstr("laser scan 1, resolution 5, still 1495\n"));
  EXPECT_THAT(r.out, HasSubstr("bad lidar 1 1\n"));
}

// Walls are 10 mm thick, sensors at the sides sit 45 mm off the middle: 1900 mm in a room of 2 m.
TEST(Programs, AnS4HasTheEightPsdsOfEyeSim) {
  const ProgramRun r = run_named("devices");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("across 1900\n"));
  // On lines at 48 and 18 degrees to the walls before the robot and beside it.
  EXPECT_THAT(r.out, HasSubstr("PSD 5 = 1285\nPSD 6 = 1285\nPSD 7 = 983\nPSD 8 = 983\n"));
}

TEST(Programs, ADeviceThatTheRobotLacksIsNamedOnceWithTheRobotsThatHaveIt) {
  const ProgramRun r = run_named("devices");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err,
            "eyebridge: warning: PSDGet: this robot has no PSD 9\n"
            "eyebridge: warning: SERVOSet: this robot has no servo 12; robots that have it: "
            "ServoBot, ServoBot-11\n"
            "eyebridge: warning: MOTORDrive: this robot has no motor 3; robots that have it: Omni, "
            "Mako, USAL\n"
            "eyebridge: warning: ENCODERRead: this robot has no encoder 3; robots that have it: "
            "Omni\n");
  EXPECT_THAT(r.out, HasSubstr("went on\n"));
}

TEST(Programs, ADeviceThatTheRobotLacksEndsTheProgramWhereThatIsAskedFor) {
  const ProgramRun r = run_named("devices", {{"EYEBRIDGE_MISSING_DEVICES", "error"}});
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_EQ(r.err,
            "eyebridge: error: PSDGet: this robot has no PSD 9; the program ends "
            "(--missing-devices error)\n");
  EXPECT_THAT(r.out, ::testing::Not(HasSubstr("went on\n")));
  const ProgramRun late =
      testing::run_program({{std::string(EYEBRIDGE_TEST_PROGRAMS) + "/devices", "late"},
                            {{"EYEBRIDGE_FAST", "true"}, {"EYEBRIDGE_MISSING_DEVICES", "error"}},
                            ""});
  EXPECT_EQ(late.exit_code, 1);
  EXPECT_THAT(late.err, HasSubstr("no servo 12; robots that have it: ServoBot, ServoBot-11; the "
                                  "program ends (--missing-devices error)\n"));
}

TEST(Programs, PerfectMotionThatRepeatsForEverIsNoticed) {
  const ProgramRun perfect = run_named("seeks", {{"EYEBRIDGE_TIME_LIMIT", "120s"}});
  EXPECT_EQ(perfect.exit_code, 0) << perfect.err;
  EXPECT_THAT(perfect.err, HasSubstr("for a minute and turned only to the same 36 headings: "));
  const ProgramRun real =
      run_named("seeks", {{"EYEBRIDGE_TIME_LIMIT", "120s"}, {"EYEBRIDGE_ERRORS", "drive 0.1 0.1"}});
  EXPECT_EQ(real.exit_code, 0) << real.err;
  EXPECT_THAT(real.err, ::testing::Not(HasSubstr("headings")));
}

TEST(Programs, GyroscopeAndAccelerometerFeelACurve) {
  const ProgramRun r = run_named("inertial");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("stands 0 0: 0, 0 0\n"));
  EXPECT_THAT(r.out, HasSubstr("curve 3000, 0 105\n"));
  EXPECT_THAT(r.out, ::testing::ContainsRegex(
                         "nowhere 1 1 1: EYEBRIDGE[A-Za-z]+: a null pointer was given\n"));
}

TEST(Programs, ARangeMatrixSeesTheWallAndTheFloor) {
  const ScratchFolder folder;
  folder.write("tof.robi", "name Seer\ndiameter 100\ntof 1 TOF_FRONT 140 0 100 0\n");
  const std::string world = folder.write("world.sim", "robot tof.robi\nSeer 1000 1000 0\n");
  const ProgramRun r = run_named("range_matrix", {{"EYEBRIDGE_WORLD", world}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  // The wall is 855 mm ahead of the sensor; from a height of 100 mm the lower edge of the lowest
  // row, 22.5 degrees down, meets the floor after 241 mm.
  EXPECT_THAT(r.out, HasSubstr("ahead 0: 855 855, floor 241\n"));
  EXPECT_THAT(r.out,
              HasSubstr("missing 1, -7: EYEBRIDGERangeMatrixGet: this robot has no tof 2\n"));
  EXPECT_THAT(r.out, HasSubstr("nowhere 1: EYEBRIDGERangeMatrixGet: a null pointer was given\n"));
}

TEST(Programs, DrivingEndsWhereItShould) {
  const ProgramRun r = run_named("driving");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("done 0 remain about half\ndone 1 remain 0\n"));
  EXPECT_THAT(r.out, HasSubstr("straight 200 0 0\nback -200 0 0\nturn 0 0 -90\nturn 0 0 90\n"));
  EXPECT_THAT(r.out, HasSubstr("curve 100 100 90\n"));
  EXPECT_THAT(r.out, HasSubstr("not ahead 1\n"));
  EXPECT_THAT(r.out, HasSubstr("drive 200 100 53\nquarter 100 -100 -90\n"));
  EXPECT_THAT(r.out, HasSubstr("nothing 0 0 0\n"));
  EXPECT_THAT(r.out, HasSubstr("speed 100 0\n"));
  EXPECT_THAT(r.out, HasSubstr("stuck 1 done -1 stalled 3\n"));
}

TEST(Programs, MotorsAndServosAnswerByNumber) {
  const ProgramRun r = run_named("motors");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("ticks fine\nreset 0\n"));
  EXPECT_THAT(r.out, HasSubstr("no motor 1, no encoder 1\n"));
  EXPECT_THAT(r.out, HasSubstr("servo 0 1 1\n"));
}

TEST(Programs, MecanumWheelsDriveSidewaysByMotorCalls) {
  const ProgramRun r = run_named("mecanum", {{"EYEBRIDGE_ROBOT", "Omni"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  for (const char* way : {"left", "right", "diagonal", "ahead", "spin"}) {
    EXPECT_THAT(r.out, HasSubstr(std::string(way) + " fine, odometry fine, encoders fine\n"));
  }
  EXPECT_THAT(r.out, HasSubstr("no motor 1, no encoder 1\n"));
  EXPECT_THAT(r.out, HasSubstr("curve 200 200 90\n"));
}

TEST(Programs, ASubmarineDivesByItsThrustersAndTellsItsHeight) {
  const ProgramRun r = run_named("submarine", {{"EYEBRIDGE_ROBOT", "USAL"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("floats 1740\nput 600 1000 1000 0, down 1000\n"));
  EXPECT_THAT(r.out, HasSubstr("dives fine\nrises fine, down fine\n"));
  EXPECT_THAT(r.out, HasSubstr("straight fine 0 0, deeper 1\nturns fine\n"));
  EXPECT_THAT(r.out, HasSubstr("no encoder 1, no speed 1\nfloor 0\n"));
  EXPECT_THAT(r.err, HasSubstr("robot 1 at z = 9000 mm is out of the water: expected 0 to 1740 "
                               "mm; it is put to 1740 mm"));
  EXPECT_THAT(r.err, Not(HasSubstr("z = -5"))) << "told once";
}

TEST(Programs, ACarDrivesArcsByVWAndSteersByItsServo) {
  const ProgramRun r = run_named("car", {{"EYEBRIDGE_ROBOT", "Car"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("straight 200 0 0\n"));
  // The rear axle's arc ends at (331, 191) mm; the centre is 80 mm before it at both ends.
  EXPECT_THAT(r.out, HasSubstr("curve 291 260 60\n"));
  EXPECT_THAT(r.out, HasSubstr("on the spot: stalled 3, waited 1, done -1\nturn 0 0 0\n"));
  EXPECT_THAT(r.out, HasSubstr("left wheel shorter\nservo left: turned left\n"));
  EXPECT_THAT(r.out, HasSubstr("servo right: turned back\n"));
  EXPECT_THAT(r.out, HasSubstr("no motor 1\n"));
}

TEST(Programs, ThreadsMayCallTogetherAndOutliveMain) {
  for (const char* fast : {"true", "false"}) {
    const ProgramRun r =
        run_named("threads", {{"EYEBRIDGE_FAST", fast}, {"EYEBRIDGE_FACTOR", "20"}});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(r.out, HasSubstr("drove\n"));
  }
}

TEST(Programs, ATimeLimitEndsAnEndlessProgram) {
  const ProgramRun r =
      run_named("endless", {{"EYEBRIDGE_TIME_LIMIT", "5s"}, {"EYEBRIDGE_LOG", "info"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr("time limit of 5 s"));
}

TEST(Programs, AnEmptyLoopEndsAtTheTimeLimitInVirtualTime) {
  const ProgramRun r = run_named("empty_loop", {{"EYEBRIDGE_TIME_LIMIT", "2s"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, AllOf(HasSubstr("warning: the program has computed for 5 s without a call"),
                           HasSubstr("longer than the time limit of 2 s; it ends")));
}

TEST(Programs, AnEmptyLoopWithoutATimeLimitEndsAtTheHangLimit) {
  const ProgramRun r = run_named("empty_loop", {{"EYEBRIDGE_HANG_LIMIT", "1s"}});
  EXPECT_EQ(r.exit_code, 124) << r.err;
  EXPECT_THAT(r.err, HasSubstr("it is ended after 1 s; --hang-limit says when"));
}

TEST(Programs, WaitingForAKeyThatCannotComeIsAnError) {
  const ProgramRun r = run_named("textbook");
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.err, HasSubstr("--keys"));
}

TEST(Programs, ResultsGoWhereTheyAreAskedFor) {
  const ScratchFolder folder;
  const ProgramRun r = run_named(
      "textbook", {{"EYEBRIDGE_KEYS", "KEY1@0s,KEY4@60s"}, {"EYEBRIDGE_OUT", folder.path()}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  for (const char* name : {"map.png", "lcd.png", "frames/0000.png", "trace.csv"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path() + "/" + name), 100U) << name;
  }
  const std::string trace = testing::file_text(folder.path() + "/trace.csv");
  EXPECT_THAT(trace, ::testing::StartsWith("t,x,y,theta,linear,angular,odometry_x,odometry_y,"
                                           "odometry_theta,range_1,range_2,range_3"));
}

TEST(Programs, TheSameRunGivesTheSameTrace) {
  const ScratchFolder a;
  const ScratchFolder b;
  for (const ScratchFolder* folder : {&a, &b}) {
    ASSERT_EQ(run_named("driving", {{"EYEBRIDGE_OUT", folder->path()}}).exit_code, 0);
  }
  const std::string first = testing::file_text(a.path() + "/trace.csv");
  EXPECT_GT(first.size(), 1000U);
  EXPECT_EQ(first, testing::file_text(b.path() + "/trace.csv"));
}

TEST(Programs, ABadSettingEndsTheProgramBeforeItsFirstCallReturns) {
  const ProgramRun r = run_named("clocks", {{"EYEBRIDGE_HAL", "simm"}});
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("EYEBRIDGE_HAL"));
  EXPECT_THAT(r.err, HasSubstr("simm"));
  EXPECT_EQ(r.out, "");
}

}  // namespace
}  // namespace eyebridge
