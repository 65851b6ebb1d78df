// Whole programs of classic RoBIOS, run as users run them, in virtual time.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_named;
using testing::ScratchFolder;

/// What the program printed; it must have ended well.
std::string output_of(const std::string& name, std::map<std::string, std::string> settings = {}) {
  const ProgramRun r = run_named(name, std::move(settings));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  return r.out;
}

TEST(ClassicPrograms, CooperativeTasksTakeTurns) {
  EXPECT_EQ(output_of("cooperate_c"),
            "status 255\nearly 0\ninit 0\nagain 1\nstatus 0\nbad priority 0\n"
            "task 1 : 1\ntask 2 : 1\ntask 1 : 2\ntask 2 : 2\ntask 1 : 3\ntask 2 : 3\n"
            "back to main, uid 0, name t1\ndead 1\ndead 1\ndead -1\npermit 1\n");
}

TEST(ClassicPrograms, PreemptiveTasksShareTheProcessorTheSameWayInEveryRun) {
  const ProgramRun first = run_named("preempt_c");
  EXPECT_THAT(first.out, HasSubstr("both ran\nwaiter 1\n"));
  EXPECT_THAT(first.out, HasSubstr("a timer gave\n"));
  EXPECT_THAT(first.out, ::testing::Not(HasSubstr("never")));
  EXPECT_THAT(first.err, HasSubstr("all tasks wait for each other"));
  EXPECT_EQ(first.exit_code, 1);
  EXPECT_EQ(run_named("preempt_c").out, first.out);
}

TEST(ClassicPrograms, InRealTimeALoopWithoutCallsDoesNotStopTheOthers) {
  const std::map<std::string, std::string> real = {{"EYEBRIDGE_FAST", "false"},
                                                   {"EYEBRIDGE_FACTOR", "20"}};
  EXPECT_EQ(output_of("spins_c", real), "main goes on\ncounted 20\n");
  EXPECT_THAT(run_named("preempt_c", real).out, HasSubstr("both ran\nwaiter 1\n"));
}

TEST(ClassicPrograms, TheDriveSpeaksMetresAndRadians) {
  const std::string out = output_of("drives_c", {{"EYEBRIDGE_LOG", "error"}});
  EXPECT_THAT(out, HasSubstr("no semantics 0\nno timescale 0\nnot open -1\ntaken 0\n"));
  EXPECT_THAT(out, HasSubstr("handle 1\nsecond 0\nits motor 0\nits encoder 0\n"));
  EXPECT_THAT(out, HasSubstr("control 0\nbad control -1\nremain 0.3\npolled 1\n"));
  EXPECT_THAT(out, HasSubstr("straight 0.30 0.00 0.00\nturned about half 1\nwait 0\n"));
  EXPECT_THAT(out, HasSubstr("turn 0.30 0.00 1.57\nmore than half a turn 1\n"));
  // A quarter of a circle of radius 0.2 to the right, from a heading of +y.
  EXPECT_THAT(out, HasSubstr("curve 0.50 0.20 0.00\nback 0.40 0.20 0.00\nno length 1\n"));
  EXPECT_THAT(out, HasSubstr("set 1.00 2.00 3.00\nspeed 0.10 0.50\n"));
  EXPECT_THAT(out, HasSubstr("stalled 1\ngiven up 0\ndone 1\n"));
  EXPECT_THAT(out, HasSubstr("null -1\nnull -1\nwrong -1\nnan -1\n"));
  EXPECT_THAT(out, HasSubstr("release 0\nagain -1\nits motor 1\n"));
}

TEST(ClassicPrograms, SensorsAreFoundByTheNumbersOfTheRobotsFile) {
  const ScratchFolder folder;
  const std::string robot = folder.write("rookie.p",
                                         "name Rookie\ndiameter 150\nspeed 40\nturn 180\n"
                                         "world empty-room.wld\n"
                                         "psd PSD_LEFT -205 90 70 0\npsd PSD_FRONT -200 0 70 0\n"
                                         "psd ODD -260 180 70 0\n"
                                         "ir IR_F -400 0 75 0\nbump BUMP_FRONT -502 -45 45\n");
  const std::string out = output_of("senses_c", {{"EYEBRIDGE_WORLD", robot}});
  // The room has 2 m and walls of 10 mm, the robot stands in its middle, the sensors sit 70 mm
  // before it.
  EXPECT_THAT(out, HasSubstr("handles 1 2 4\nnone 0\ntwice 0\nunstarted 925\n"));
  EXPECT_THAT(out, HasSubstr("start 0\njoin 0\nwrong -1\ncheck 0\ncheck 1\nleft 925\nodd 925\n"));
  EXPECT_THAT(out, HasSubstr("tick 1\ntwo -1\nstop 0\nonce 0\nbusy 1\nrelease 0\nafter -1\n"));
  EXPECT_THAT(out, HasSubstr("far 0\nquiet -1\nstamp 0\nnear 1\nhit 0\nstamped 1\nonce only -1\n"));
  EXPECT_THAT(out, HasSubstr("release 0\nagain 11110000\nir release 0\nafter -1\n"));
  EXPECT_THAT(out, HasSubstr("early -1\ncompass 0\nstart 0\nagain 1\ncheck 0\nnothing yet -1\n"));
  EXPECT_THAT(out, HasSubstr("check 1\neast 90\nstop 0\nnorth 0\ncalibrate 0\nbad mode 1\n"));
}

TEST(ClassicPrograms, WheelsAndServosAreMovedByMasks) {
  const std::string out = output_of("wheels_c");
  EXPECT_THAT(out, HasSubstr("handles 1 2 1 2\ndrive 0\nwrong -1\nnone -1\n"));
  EXPECT_THAT(out,
              HasSubstr("counted 1\nboth 1\ntwo 0\nmetres 1\nreset 0\nnow 0\nmetres stay 1\n"));
  EXPECT_THAT(out, HasSubstr("odo 0\nmetres 0.0\nmotor 1\nmotor 1\nno encoder 0\n"));
  EXPECT_THAT(out, HasSubstr("release 0\nagain -1\npartly 1\nnot at all 11110000\nrelease 0\n"));
  EXPECT_THAT(out, HasSubstr("servos 1 2\nno servo 0\nset 0\ntoo far -1\nwrong -1\nrelease 0\n"));
}

TEST(ClassicPrograms, ServosTurnTheWheelsOfARobotThatHasThemThere) {
  const ProgramRun r = run_named("servo_wheels_c", {{"EYEBRIDGE_ROBOT", "ServoBot"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  // One turn a second of 1016 ticks: forward for 2 s, backward for half a second.
  EXPECT_EQ(r.out, "wheels 1\nturned 2032\nstands at 2032\nback at 1524\n");
  const ProgramRun on_motors = run_named("servo_wheels_c");
  EXPECT_EQ(on_motors.out, "wheels 0\n");
  EXPECT_THAT(on_motors.err, HasSubstr("SERVOInit: this robot has no servo -612 (SERVO12); robots "
                                       "that have it: ServoBot, ServoBot-11\n"));
}

TEST(ClassicPrograms, TheScreenShowsSevenRowsAndTheLabels) {
  const ScratchFolder folder;
  const ProgramRun r =
      testing::run_program({{EYEBRIDGE_TEST_PROGRAMS "/screen_c", "keep"},
                            {{"EYEBRIDGE_FAST", "true"}, {"EYEBRIDGE_OUT", folder.path()}},
                            ""});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("at 6 15\nno row 1\nno column 1\nno key 1\nno pixel 1\n"));
  EXPECT_THAT(r.out, HasSubstr("pixels 1 1 0 -1\narea 1 1\ncorners 1\nnulls 6\nlabels 0\n"));
  std::ifstream file(folder.path() + "/lcd.txt");
  const std::string lcd{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(lcd, HasSubstr("int 42  7  3.1\n"));
  EXPECT_THAT(lcd, HasSubstr("FFA5-5   6   2.5\n"));
  EXPECT_THAT(lcd, HasSubstr("          place\nlast           *\n"));
  EXPECT_THAT(lcd, HasSubstr("A   two LONGEND\n"));
  EXPECT_GT(std::filesystem::file_size(folder.path() + "/lcd.png"), 100U);
}

TEST(ClassicPrograms, AnotherSizeOfTheScreenIsAnError) {
  const ProgramRun r = run_named("screen_c", {{"EYEBRIDGE_LCD", "560x400"}});
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("EYEBRIDGE_LCD: found 560x400, but the screen of classic RoBIOS"));
}

TEST(ClassicPrograms, TheCameraGivesImagesAtItsRate) {
  const std::string out = output_of("sees_c");
  EXPECT_THAT(out,
              HasSubstr("early 1\nearly -1\ncamera 1\nfps 1, 82 x 62\ndifference 0\nrate 1\n"));
  EXPECT_THAT(out, HasSubstr("sobel 0\nedges 1\nlaplace 0\nedges 1\ndithered 5084\nshown 1\n"));
  EXPECT_THAT(out, HasSubstr("mono 0\nrgb 0\nbayer 0\nnull 1\nsame image 1\nnull 1\nnull 1\n"));
  EXPECT_THAT(out, HasSubstr("mode 0\nbad mode 1\nrelease 0\n"));
}

TEST(ClassicPrograms, ARobotWithoutCameraSaysSo) {
  const ProgramRun r = run_named("m6_c", {{"EYEBRIDGE_CAMERA", "none"}});
  EXPECT_THAT(r.out, HasSubstr("camera 0, drive 1\nframe 1\n"));
}

TEST(ClassicPrograms, TicksAndTimersFollowVirtualTime) {
  EXPECT_EQ(output_of("times_c"),
            "count 0\ncount 150\ncount 200\ntime 0:0:2.25\nset 0\nno time 1\ntime 0:0:1\n"
            "fast 100 slow 10\nheld 1, then 1\ndetach 1\nagain 0\ndetach 1\nbad 0\nbad 0\n"
            "timers 16\ndate 1.1.2000\nleap year 0\nno date 1\n");
}

TEST(ClassicPrograms, TheSystemTellsWhoTheRobotIs) {
  const std::string out = output_of("system_c", {{"EYEBRIDGE_ROBOT", "LabBot"}});
  EXPECT_THAT(out, HasSubstr("version 6.5, name LabBot\ntype 1\nspeed 25000000\nid 1\n"));
  EXPECT_THAT(out, HasSubstr("put 0\ntoo big 1\nno variable 1\nget 1234 12 34\nno variable -1\n"));
  EXPECT_THAT(out, HasSubstr("word 12ff\nbefore 0\nbefore 4\nnow 5\nin 255\nno latch 0\n"));
  EXPECT_THAT(out,
              HasSubstr("port 5a 0 f\nad 1\nno channel -1\noff 0\nbad off 1\nloader 4\nhdt 1\n"));
  EXPECT_THAT(out, HasSubstr("m6 0\nbank 0\nwrite 0\nread 1\nno line -1\nadc 1\nno adc 0\n"));
}

TEST(ClassicPrograms, ARobotsNumberMayBeADigit) {
  EXPECT_THAT(output_of("system_c", {{"EYEBRIDGE_ID_AS_ASCII", "true"}}), HasSubstr("id 49\n"));
}

TEST(ClassicPrograms, LinesRadioRemoteAndSoundAnswerAsTheManualsSay) {
  const std::string out = output_of("lines_c", {{"EYEBRIDGE_KEYS", "IRTV_5@3s,IRTV_RED@4s"}});
  EXPECT_THAT(out, HasSubstr("no line 10\nno line 10\nno line 10\nno line -246\nnull 3\n"));
  EXPECT_THAT(out,
              HasSubstr("off 1\nradio 0\nid 1\nsend 0\nto all 0\nto the host 0\ntoo long 1\n"));
  EXPECT_THAT(out, HasSubstr("waiting 1\ngot 5 bytes from 1: hello\nstatus 0\nthere 1\nnull 1\n"));
  EXPECT_THAT(out,
              HasSubstr("early 0\nremote 0\nbad type 1\ncode 53\npressed 82\nread 82\nnone 0\n"));
  EXPECT_THAT(out, HasSubstr("too low 1\nnull 0\nno sample 0\ntone 0\ntook 1\nrecord 0\n"));
}

TEST(ClassicPrograms, AProgramOfTheM6UsesNames) {
  const std::string out = output_of("m6_c");
  EXPECT_THAT(out, HasSubstr("camera 1, drive 1\nframe 0\nshown 0\nsensors 1 2\nunknown 0\n"));
  EXPECT_THAT(out, HasSubstr("release 0\nreleased -1\nother 1\nall 0\nother -1\nlists 1\n"));
  EXPECT_EQ(output_of("m6_cpp"),
            "psd 1\nrange 1\ncamera 1\nframe 0\nrelease 0\ndrive 1\nby number 0\ntaken 0\nnone 0\n"
            "release 0\ncamera by number 17\n");
}

TEST(ClassicPrograms, EndAsTheyWant) {
  const auto run = [](const std::string& how) {
    return testing::run_program({{EYEBRIDGE_TEST_PROGRAMS "/ends_c", how},
                                 {{"EYEBRIDGE_FAST", "true"}, {"EYEBRIDGE_KEYS", "KEY1@1s"}},
                                 ""});
  };
  EXPECT_EQ(run("").out, "task\nmain goes on\n");
  EXPECT_EQ(run("").exit_code, 0);
  EXPECT_EQ(run("exit").exit_code, 7);
  EXPECT_EQ(run("kill").exit_code, 0);
  EXPECT_THAT(run("key").out, HasSubstr("error 0\n"));
  for (const auto& [how, message] :
       {std::pair{"panic", "OSPanic: no way"}, std::pair{"error", "OSError: dead 5"},
        std::pair{"stuck", "all tasks wait for each other"}}) {
    const ProgramRun r = run(how);
    EXPECT_EQ(r.exit_code, 1);
    EXPECT_THAT(r.err, HasSubstr(message));
  }
}

}  // namespace
}  // namespace eyebridge
