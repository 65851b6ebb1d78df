// Lines, inputs, sounds, the remote control, commands, old numbers: C programs from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::run_named;

TEST(ProgramsIo, LinesAndInputsAreThoseOfABoard) {
  for (const auto& clock : testing::kClocks) {
    const ProgramRun r = run_named("lines", clock);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(r.out, HasSubstr("start 00FF\n"));
    EXPECT_THAT(r.out, HasSubstr("write 0 1 0\nany state 0 1\n"));
    EXPECT_THAT(r.out, HasSubstr("J 0 0\nI 0 1\no 0 0\ni 0 0\n"));
    EXPECT_THAT(r.out, HasSubstr("bad 1 1 -1 1 1\n"));
    EXPECT_THAT(r.out, HasSubstr("analog 1515 0 2048 740\nbad analog -1 -1\nmicrophone 2048\n"));
    EXPECT_THAT(r.out, HasSubstr("record 0\nsamples 100 1, waited 1\nonce 0\n"));
    EXPECT_THAT(r.out, HasSubstr("bad record 1 1 1 0\nsecond 7\n"));
    EXPECT_THAT(r.err, HasSubstr("DIGITALRead: digital: got 17, expected a line, 1 … 16"));
  }
}

TEST(ProgramsIo, ALostInputIsNoSample) {
  const ProgramRun r = run_named("lines", {{"EYEBRIDGE_FAULTS", "analog:8 lose @50ms"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("record 0\nsamples 0 1"));
  EXPECT_THAT(r.err, HasSubstr("ANALOGTransfer: analog 8: --faults"));
}

TEST(ProgramsIo, SoundsTakeTheirTime) {
  const testing::ScratchFolder folder;
  // 0.5 s of 8000 samples of 8 bits a second.
  std::string wav(
      "RIFF\0\0\0\0WAVEfmt \x10\0\0\0\1\0\1\0\x40\x1F\0\0\x40\x1F\0\0\1\0\x08\0data\xA0\x0F\0\0",
      44);
  wav += std::string(4000, '\x80');
  const std::string file = folder.write("a.wav", wav);
  const ProgramRun r = testing::run_program(
      {{std::string(EYEBRIDGE_TEST_PROGRAMS) + "/sounds", file}, {{"EYEBRIDGE_FAST", "true"}}, ""});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("done at first 1\nbeep 0 0\nbeeped 100\n"));
  EXPECT_THAT(r.out, HasSubstr("play 0\nplayed 500\nbad 1 1\n"));
  EXPECT_THAT(r.err, HasSubstr("AUPlay: sound: no-such-file.wav: no such file"));
}

TEST(ProgramsIo, CodesOfTheRemoteControlComeFromTheScript) {
  const std::string script = "IRTV_5@1s,IRTV_RIGHT@2s,IRTV_POWER@2.5s,IRTV_OK@4s,KEY2@6s";
  const ProgramRun r = run_named("remote", {{"EYEBRIDGE_KEYS", script}});
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.out, HasSubstr("status 1 none 0\ngot 5 at 1\nread 1 1 0\nflush 0 0\nkey 2\n"));
  EXPECT_THAT(r.out, Not(HasSubstr("never")));
  EXPECT_THAT(r.err, HasSubstr("waits for a key of the remote control that can never come"));
}

TEST(ProgramsIo, CommandsRunInBothForms) {
  const ProgramRun r = run_named("execute");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("one\n0 two\ncut 0 1023\nnull 1 1 1\n"));
  EXPECT_THAT(r.out, HasSubstr("version 0 1.0, io 1 ''\nmachine 700000000 1 1 0 EyeBot\n"));
  const ProgramRun cpp = run_named("execute_cpp");
  EXPECT_EQ(cpp.exit_code, 0) << cpp.err;
  EXPECT_THAT(cpp.out, HasSubstr("one\n0 two\nclosed 1 1 1 1\nradio off -1 -1\n"));
}

TEST(ProgramsIo, PsdsMayCountAsIn2015) {
  const ProgramRun now = run_named("old_psd");
  EXPECT_THAT(now.out, HasSubstr("1 1435 2 950 3 950 raw 950\nfront 1 left 2\n")) << now.err;
  const ProgramRun then = run_named("old_psd", {{"EYEBRIDGE_PSD_NUMBERS", "2015"}});
  EXPECT_THAT(then.out, HasSubstr("1 950 2 1435 3 950 raw 1435\n")) << then.err;
  const ProgramRun file = run_named(
      "old_psd", {{"EYEBRIDGE_WORLD", EYEBRIDGE_SOURCE_DIR "/worlds/robots/S4-2015.robi"}});
  EXPECT_THAT(file.out, HasSubstr("1 950 2 1435 3 950 raw 1435\n")) << file.err;
}

TEST(ProgramsIo, AnyNumberOfTimersRunOnTimeAndOsWaitDoesNotNotice) {
  const auto r = run_named("many_timers");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("quick 1000\nwaited 1000\ncalls 5000\n"));
  const auto real = run_named("many_timers", {{"EYEBRIDGE_FAST", "false"}});
  EXPECT_EQ(real.exit_code, 0) << real.err;
  EXPECT_THAT(real.out, HasSubstr("\nwaited 1"));  // not less than asked: 1000 ms and more
}

TEST(ProgramsIo, VwControlCanBeSwitchedOff) {
  const ProgramRun r = run_named("control");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("control 0 bad 1\noff 0\ndrove 1 stands 1\nagain 0\non 1\n"));
}

}  // namespace
}  // namespace eyebridge
