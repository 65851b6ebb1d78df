#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "eyebridge/camera/recording/frame_table.hpp"
#include "replay/ebrec.hpp"
#include "run_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;

std::string world(const std::string& name) {
  return std::string(EYEBRIDGE_SOURCE_DIR) + "/worlds/" + name;
}

ProgramRun run(const std::string& program, const std::string& world_name,
               std::map<std::string, std::string> settings = {}) {
  settings["EYEBRIDGE_FAST"] = "true";
  settings["EYEBRIDGE_WORLD"] = world(world_name);
  return testing::run_program({{program}, settings, ""});
}

TEST(Square, EndsWhereItStarted) {
  const ProgramRun r = run(EYEBRIDGE_SQUARE, "empty-room.wld");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "back at 0 0, 0 deg\n");
}

TEST(Ping, TwoRobotsCountTogether) {
  const std::string group =
      "udp:239.192.7.9:" + std::to_string(20000 + ::getpid() % 40000) + "?id=";
  const auto play = [&](int id) {
    return testing::run_program(
        {{EYEBRIDGE_PING},
         {{"EYEBRIDGE_FACTOR", "20"}, {"EYEBRIDGE_RADIO", group + std::to_string(id)}},
         ""});
  };
  ProgramRun one;
  std::thread other([&] { one = play(1); });
  const ProgramRun two = play(2);
  other.join();
  EXPECT_EQ(one.out, "robot 1 counted to 20\n") << one.err;
  EXPECT_EQ(two.out, "robot 2 counted to 19\n") << two.err;
}

// Ten minutes of ten robots, and an evolution, are hours of a sanitized build without optimisation.
#if !defined(__SANITIZE_ADDRESS__)

TEST(Soccer, FiveAgainstFivePlayTheSameTenMinutesEachTime) {
  const auto play = [] {
    return testing::run_program({{EYEBRIDGE_SOCCER, "600"},
                                 {{"EYEBRIDGE_FAST", "true"},
                                  {"EYEBRIDGE_ROBOTS", "all"},
                                  {"EYEBRIDGE_WORLD", world("soccer-5v5.sim")}},
                                 ""});
  };
  const auto state_of = [](const std::string& messages) {
    return messages.substr(std::min(messages.find("eyebridge: 10 robots, 600."), messages.size()),
                           27) +
           messages.substr(std::min(messages.find("trace "), messages.size()), 22);
  };
  const ProgramRun first = play();
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("goal after "));
  EXPECT_EQ(state_of(first.err), "eyebridge: 10 robots, 600.0trace 4e5c966805d0bc31");
  const ProgramRun second = play();
  EXPECT_EQ(second.out, first.out);
  EXPECT_EQ(state_of(second.err), state_of(first.err));
}

#endif

TEST(Soccer, OneRobotScoresAgainAndAgainTheSameWayEachTime) {
  const auto play = [](const std::string& folder) {
    return testing::run_program({{EYEBRIDGE_SOCCER, "60"},
                                 {{"EYEBRIDGE_FAST", "true"},
                                  {"EYEBRIDGE_WORLD", world("soccer-practice.sim")},
                                  {"EYEBRIDGE_OUT", folder}},
                                 ""});
  };
  const testing::ScratchFolder a;
  const testing::ScratchFolder b;
  const ProgramRun first = play(a.path());
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr(" s: 3 to 0\n"));
  EXPECT_EQ(play(b.path()).out, first.out);
  for (const char* name : {"/trace.csv", "/collisions.csv"}) {
    const std::string text = testing::file_text(a.path() + name);
    EXPECT_EQ(testing::file_text(b.path() + name), text);
    EXPECT_GT(text.size(), 30U) << "more than its header";
  }
  EXPECT_THAT(testing::file_text(a.path() + "/collisions.csv"),
              ::testing::StartsWith("t,robot,with,x,y\n"));
}

TEST(ClassicPatrol, DrivesToAndFroWhileItIsWatched) {
  const ProgramRun r = run(EYEBRIDGE_CLASSIC_PATROL, "empty-room.wld");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_THAT(r.out, HasSubstr("leg 1: 535 mm to the wall\n"));
  EXPECT_THAT(r.out, HasSubstr("leg 6: 935 mm to the wall\n"));
  EXPECT_THAT(r.out, HasSubstr("patrol ended after "));
}

TEST(WallFollower, KeepsItsDistanceToTheWall) {
  const testing::ScratchFolder folder;
  const ProgramRun r =
      run(EYEBRIDGE_WALL_FOLLOWER, "empty-room.wld", {{"EYEBRIDGE_OUT", folder.path()}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  // Columns: t, x, y, theta, linear, angular, three of odometry, then the PSDs: front, left, …
  std::istringstream trace(testing::file_text(folder.path() + "/trace.csv"));
  std::string line;
  std::getline(trace, line);
  int rows = 0;
  int near_the_wall = 0;
  while (std::getline(trace, line)) {
    std::vector<double> column;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) column.push_back(std::stod(cell));
    ASSERT_GE(column.size(), 12U);
    if (column[0] < 20) continue;
    ++rows;
    near_the_wall += column[10] > 0.08 && column[10] < 0.35 ? 1 : 0;
  }
  ASSERT_GT(rows, 400);
  EXPECT_GT(near_the_wall, rows * 8 / 10);
}

#if !defined(__SANITIZE_ADDRESS__)  // an evolution takes minutes at -O0
/// The last line of `text`, in words.
std::vector<std::string> last_words(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);) last = line;
  std::istringstream words(last);
  return {std::istream_iterator<std::string>(words), {}};
}

/// Number behind `word` in `text`.
double number_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  return at == std::string::npos ? -1 : std::stod(text.substr(at + word.size()));
}

TEST(EvolvedWallFollower, FinishesItsCourseAsARobotProgram) {
  const ProgramRun evolution =
      testing::run_program({{EYEBRIDGE_EVOLVE_WALL_FOLLOWER, "6", "1"}, {}, ""});
  ASSERT_EQ(evolution.exit_code, 0) << evolution.out << evolution.err;
  EXPECT_THAT(evolution.out, HasSubstr("finished its course 3 times of 3\n"));
  EXPECT_GT(number_after(evolution.out, "generation 6: best"),
            number_after(evolution.out, "generation 1: best"));
  std::vector<std::string> words = last_words(evolution.out);
  ASSERT_EQ(words.size(), 7U) << evolution.out;
  ASSERT_EQ(words[0], "evolved_follower");
  words[0] = EYEBRIDGE_EVOLVED_FOLLOWER;
  const ProgramRun r = testing::run_program(
      {words, {{"EYEBRIDGE_FAST", "true"}, {"EYEBRIDGE_WORLD", world("corridor.wld")}}, ""});
  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  EXPECT_EQ(r.err, "") << "it hits nothing";
  EXPECT_THAT(r.out, HasSubstr("result finished 1\n"));
}
#endif

TEST(EvolvedWallFollower, EvolvesTheSameWayAgain) {
  const auto evolve = [](const char* seed) {
    return testing::run_program({{EYEBRIDGE_EVOLVE_WALL_FOLLOWER, "2", seed}, {}, ""}).out;
  };
  const std::string one = evolve("1");
  EXPECT_EQ(evolve("1"), one);
  EXPECT_NE(evolve("2"), one);
}

TEST(EvolvedWallFollower, SaysWhatItExpects) {
  EXPECT_EQ(testing::run_program({{EYEBRIDGE_EVOLVE_WALL_FOLLOWER, "none"}, {}, ""}).exit_code, 2);
  const ProgramRun r = testing::run_program({{EYEBRIDGE_EVOLVED_FOLLOWER, "1"}, {}, ""});
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("expected keep gain damping speed front_stop turn"));
}

TEST(ColourFollower, FindsTheRedThing) {
  const ProgramRun r = run(EYEBRIDGE_COLOUR_FOLLOWER, "colour-targets.sim");
  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  EXPECT_THAT(r.out, HasSubstr("found it"));
}

/// All that a recording holds of a run: what the devices were asked and said, and every frame.
struct RecordedRun {
  explicit RecordedRun(const std::string& file) : robot(hal::read_recording(file)) {
    camera::FrameReader reader(file);
    for (std::size_t i = 0; i < reader.frames().size(); ++i) {
      const camera::RecordedFrame& row = reader.frames()[i];
      times.push_back(row.given);
      frames.push_back(reader.read(i).value());
    }
  }
  hal::Recording robot;
  std::vector<Time> times;
  std::vector<camera::Frame> frames;
};

void expect_same_calls(const hal::Recording& a, const hal::Recording& b, bool with_times) {
  ASSERT_EQ(a.exchanges.size(), b.exchanges.size());
  for (std::size_t i = 0; i < a.exchanges.size(); ++i) {
    ASSERT_EQ(a.exchanges[i].name, b.exchanges[i].name) << i;
    ASSERT_EQ(a.exchanges[i].request, b.exchanges[i].request) << i;
    ASSERT_EQ(a.exchanges[i].reply.value(), b.exchanges[i].reply.value()) << i;
    if (with_times) {
      ASSERT_EQ(a.exchanges[i].time, b.exchanges[i].time) << i;
    }
  }
}

void expect_same_frames(const RecordedRun& a, const RecordedRun& b) {
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    ASSERT_EQ(a.frames[i].bytes, b.frames[i].bytes) << i;
    ASSERT_EQ(a.frames[i].time, b.frames[i].time) << i;
    ASSERT_EQ(a.frames[i].sequence, b.frames[i].sequence) << i;
  }
}

TEST(ColourFollower, DrivesTheSameWayAgainByItsRecordedFrames) {
  const testing::ScratchFolder folder;
  const std::string then_file = folder.path() + "/then.ebrec";
  const std::string now_file = folder.path() + "/now.ebrec";
  const ProgramRun then =
      run(EYEBRIDGE_COLOUR_FOLLOWER, "colour-targets.sim", {{"EYEBRIDGE_RECORD", then_file}});
  ASSERT_EQ(then.exit_code, 0) << then.err;
  const ProgramRun now = testing::run_program({{EYEBRIDGE_COLOUR_FOLLOWER},
                                               {{"EYEBRIDGE_HAL", "replay:" + then_file},
                                                {"EYEBRIDGE_CAMERA", "frames:" + then_file},
                                                {"EYEBRIDGE_RECORD", now_file}},
                                               ""});
  EXPECT_EQ(now.exit_code, 0) << now.err;
  EXPECT_EQ(now.out, then.out);
  EXPECT_EQ(now.err, "");
  const RecordedRun first(then_file);
  const RecordedRun again(now_file);
  EXPECT_GT(first.frames.size(), 100U);
  expect_same_calls(first.robot, again.robot, true);
  expect_same_frames(first, again);
  EXPECT_EQ(first.times, again.times);
}

TEST(ColourFollower, ARunInRealTimeCanBeDrivenAgainFrameByFrame) {
  const testing::ScratchFolder folder;
  const std::string then_file = folder.path() + "/then.ebrec";
  const std::string now_file = folder.path() + "/now.ebrec";
  // Frames are missed in real time, and which ones is chance: all the more must be the same.
  // Not faster: CAMGet gives up after 2 s of the robot's time, of which a recording says nothing.
  const ProgramRun then = testing::run_program({{EYEBRIDGE_COLOUR_FOLLOWER},
                                                {{"EYEBRIDGE_WORLD", world("colour-targets.sim")},
                                                 {"EYEBRIDGE_FACTOR", "2"},
                                                 {"EYEBRIDGE_RECORD", then_file}},
                                                ""});
  const ProgramRun now =
      testing::run_program({{EYEBRIDGE_COLOUR_FOLLOWER},
                            {{"EYEBRIDGE_HAL", "replay:" + then_file},
                             {"EYEBRIDGE_CAMERA", "frames:" + then_file + "?pick=each"},
                             {"EYEBRIDGE_RECORD", now_file}},
                            ""});
  EXPECT_EQ(now.exit_code, then.exit_code) << now.err;
  EXPECT_EQ(now.out, then.out);
  const RecordedRun first(then_file);
  const RecordedRun again(now_file);
  expect_same_calls(first.robot, again.robot, false);
  expect_same_frames(first, again);
}

TEST(ColourFollower, FramesAreKeptAsTheSettingSays) {
  const testing::ScratchFolder folder;
  const std::string file = folder.path() + "/run.ebrec";
  for (const auto& [how, bytes] : {std::pair{"none", 0}, {"mjpeg", 1}}) {
    const ProgramRun r = run(EYEBRIDGE_COLOUR_FOLLOWER, "colour-targets.sim",
                             {{"EYEBRIDGE_RECORD", file},
                              {"EYEBRIDGE_RECORD_FRAMES", how},
                              {"EYEBRIDGE_TIME_LIMIT", "1s"}});
    ASSERT_EQ(r.exit_code, 0) << r.err;
    camera::FrameReader reader(file);
    EXPECT_EQ(reader.frames().empty(), bytes == 0) << how;
    for (const camera::RecordedFrame& frame : reader.frames()) {
      EXPECT_EQ(frame.codec, camera::FrameCodec::Mjpeg);
    }
  }
  EXPECT_EQ(
      run(EYEBRIDGE_COLOUR_FOLLOWER, "colour-targets.sim", {{"EYEBRIDGE_RECORD_FRAMES", "gif"}})
          .exit_code,
      2);
}

}  // namespace
}  // namespace eyebridge
