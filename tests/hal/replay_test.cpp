// Runs that are recorded, recordings that answer, and files that are none.

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/frame_sink.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"
#include "eyebridge/hal/registry.hpp"
#include "replay/ebrec.hpp"
#include "replay/numbers.hpp"
#include "replay/open_replay.hpp"
#include "replay/recorder.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class Replay : public testing::Test {
 protected:
  Replay() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    file_ = testing::TempDir() + "/replay_" + info->name() + ".ebrec";
  }
  ~Replay() override {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file_ + end);
  }

  /// The rigs' robot in virtual time, 1 m before a wall, recorded.
  Rig recorded() {
    Rig rig = lockstep_rig(facing(1.0));
    rig.backend = with_recording(std::move(rig.backend), file_, *rig.log);
    return rig;
  }
  std::unique_ptr<Backend> replay(const std::string& options = "") {
    const Config config = rig_config({{"hal", "replay:" + file_ + options}});
    return open_backend({config, log_});
  }
  /// What is said about the file; "" when it can be replayed.
  std::string complaint(const std::string& options = "") {
    try {
      replay(options);
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  }
  void run_sql(const char* sql) const {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(file_.c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(database);
  }

  std::string file_;
  KeepingLog log_;
};

/// A short course that meets all kinds of devices; what it saw.
std::vector<double> drive_and_look(Backend& backend) {
  std::vector<double> seen;
  EXPECT_TRUE(backend.drive()->start({0.2, 0.3, 0.25}));
  for (int i = 0; i < 20; ++i) {
    backend.clock().wait_until(backend.clock().now() + std::chrono::milliseconds(100));
    for (const int id : {1, 2, 3, 4}) seen.push_back(backend.range_sensor(id)->read().value());
    seen.push_back(backend.drive()->status().value().remaining);
    seen.push_back(backend.drive()->odometry().value().theta);
    seen.push_back(backend.drive()->measured_twist().value().linear);
    seen.push_back(backend.encoder(1)->read().value());
    seen.push_back(backend.compass()->read().value());
    seen.push_back(backend.gyroscope()->read().value());
    seen.push_back(backend.accelerometer()->read().value().y);
    seen.push_back(backend.proximity(1)->read().value() ? 1.0 : 0.0);
    seen.push_back(to_seconds(backend.clock().now()));
  }
  EXPECT_TRUE(backend.lidar()->configure(1.0, 0.0, 3));
  std::vector<double> scan(3);
  EXPECT_TRUE(backend.lidar()->read(scan));
  seen.insert(seen.end(), scan.begin(), scan.end());
  EXPECT_FALSE(backend.servo(1)->set(2.0));
  EXPECT_TRUE(backend.motor(1)->set_pid(1, 2, 3));
  backend.stop();
  return seen;
}

TEST_F(Replay, GivesTheSameProgramTheSameRun) {
  const std::vector<double> then = drive_and_look(*recorded().backend);
  EXPECT_EQ(drive_and_look(*replay()), then);
  EXPECT_THAT(log_.messages(Severity::Error), IsEmpty());
  EXPECT_THAT(log_.messages(Severity::Warning), IsEmpty());
}

TEST_F(Replay, HasTheDevicesOfTheAbsentRobot) {
  const Rig rig = recorded();
  rig.backend->stop();
  const auto backend = replay();
  EXPECT_EQ(backend->range_sensor(9), nullptr);
  EXPECT_EQ(backend->motor(3), nullptr);
  EXPECT_EQ(backend->world(), nullptr);
  EXPECT_EQ(backend->range_sensor(4)->out_of_range(), rig.backend->range_sensor(4)->out_of_range());
  EXPECT_EQ(backend->lidar()->max_range(), rig.backend->lidar()->max_range());
  EXPECT_EQ(backend->lidar()->shape(), rig.backend->lidar()->shape());
}

TEST_F(Replay, NamesTheFirstDeviationWithItsTime) {
  drive_and_look(*recorded().backend);
  const auto backend = replay();
  ASSERT_TRUE(backend->drive()->start({0.2, 0.3, 0.25}));
  EXPECT_EQ(backend->range_sensor(2)->read().error().code, Errc::Corrupt);
  const std::string expected =
      "replay: at 0.100 s, exchange 2: the program calls psd 2 read, the recording has psd 1 read";
  EXPECT_EQ(backend->range_sensor(1)->read().error().what, expected)
      << "nothing is right after that";
  EXPECT_THAT(log_.messages(Severity::Error), testing::ElementsAre(expected));
}

TEST_F(Replay, ComparesTheNumbersOfCommands) {
  drive_and_look(*recorded().backend);
  const auto backend = replay();
  EXPECT_THAT(backend->drive()->start({0.2, 0.3, 0.26}).error().what,
              HasSubstr("calls drive 1 start (0.2 0.3 0.26), the recording has drive 1 start "
                        "(0.2 0.3 0.25)"));
}

TEST_F(Replay, SaysWhenTheProgramEndsEarlyOrLate) {
  drive_and_look(*recorded().backend);
  auto backend = replay();
  ASSERT_TRUE(backend->drive()->start({0.2, 0.3, 0.25}));
  backend->stop();
  EXPECT_THAT(
      log_.messages(Severity::Warning),
      testing::ElementsAre("replay: the program has ended after 1 of 245 recorded exchanges"));
  backend = replay();
  drive_and_look(*backend);
  EXPECT_THAT(backend->compass()->read().error().what, HasSubstr("the recording has its end"));
}

TEST_F(Replay, LenientlyAnswersByTime) {
  const std::vector<double> then = drive_and_look(*recorded().backend);
  const auto backend = replay("?mode=lenient");
  RangeSensor& front = *backend->range_sensor(1);
  EXPECT_EQ(front.read().value(), then[0]) << "before the first reading";
  EXPECT_TRUE(backend->drive()->set_speed({1.0, 0.0}));
  backend->clock().wait_until(std::chrono::milliseconds(550));
  EXPECT_EQ(front.read().value(), then[4 * 13]) << "of 0.5 s";
  backend->clock().wait_until(std::chrono::seconds(60));
  EXPECT_EQ(front.read().value(), then[19 * 13]);
  EXPECT_EQ(front.read_raw().error().code, Errc::Unsupported) << "was never read";
}

TEST_F(Replay, FailuresAreRecordedToo) {
  {
    const Rig rig = recorded();
    EXPECT_FALSE(rig.backend->servo(1)->set(7.0));
    rig.backend->stop();
  }
  const Recording recording = read_recording(file_);
  ASSERT_EQ(recording.exchanges.size(), 1U);
  const Exchange& e = recording.exchanges[0];
  EXPECT_EQ(e.device + "." + e.name, "servo.set");
  EXPECT_EQ(e.request, Values{7.0});
  EXPECT_EQ(e.reply.error().code, Errc::OutOfRange);
  EXPECT_EQ(replay()->servo(1)->set(7.0).error().what, e.reply.error().what);
}

TEST_F(Replay, ARecordingKnowsWhereItCameFrom) {
  const RecordingOrigin origin{"./prog --fast 'a'", "serial:/dev/ttyACM0", "maze.maz"};
  Rig rig = lockstep_rig(facing(1.0));
  with_recording(std::move(rig.backend), file_, *rig.log, origin)->stop();
  EXPECT_EQ(read_recording(file_).origin, origin);
  run_sql("DELETE FROM meta WHERE key<>'version'");
  EXPECT_EQ(read_recording(file_).origin, RecordingOrigin{}) << "older ones do not tell";
}

TEST_F(Replay, AProgramThatIsKilledLeavesAllButItsLastSecond) {
  const pid_t child = fork();
  if (child == 0) {
    const Rig rig = recorded();
    for (int i = 0; i < 100; ++i) {
      rig.wait(0.1);
      static_cast<void>(rig.backend->compass()->read());
    }
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  const Recording recording = read_recording(file_);
  ASSERT_FALSE(recording.exchanges.empty());
  EXPECT_GE(recording.exchanges.back().time, std::chrono::milliseconds(9000));
}

TEST_F(Replay, RefusesFilesThatAreNoRecordings) {
  EXPECT_THAT(complaint(), HasSubstr(file_ + ": no such file: expected a recording"));
  std::ofstream(file_) << "not a database, but long enough to look at, and then some more text, "
                          "because SQLite reads a hundred bytes before it says so";
  EXPECT_THAT(complaint(), HasSubstr("file is not a database: expected a recording (.ebrec)"));
  std::filesystem::remove(file_);
  run_sql("CREATE TABLE other(x)");
  EXPECT_THAT(complaint(),
              HasSubstr("found the table 'other' that it should not have: expected a recording"));
}

TEST_F(Replay, RefusesDamagedRecordings) {
  drive_and_look(*recorded().backend);
  EXPECT_EQ(complaint(), "");
  run_sql("UPDATE exchange SET reply='1 x' WHERE seq=2");
  EXPECT_THAT(complaint(), HasSubstr("found '1 x', expected numbers"));
  run_sql("UPDATE exchange SET reply=NULL WHERE seq=2");
  EXPECT_THAT(complaint(), HasSubstr("neither a reply nor a known error"));
  run_sql("UPDATE exchange SET reply='1' WHERE seq=2; INSERT INTO device VALUES('wing',1,'')");
  EXPECT_THAT(complaint(), HasSubstr("unknown device 'wing'"));
  run_sql("DELETE FROM device WHERE kind='wing'; UPDATE exchange SET t=9223372036854775807");
  EXPECT_THAT(complaint(), HasSubstr("found the time 9223372036854775807 ns, expected 0 ..."));
  run_sql("UPDATE exchange SET t=0; UPDATE meta SET value='2'");
  EXPECT_THAT(complaint(), HasSubstr("its version is '2', expected 1"));
}

TEST_F(Replay, RefusesRecordingsOfACameraAlone) {
  { const camera::RecordingFile file(file_, {}); }
  EXPECT_THAT(complaint(),
              HasSubstr("found a recording without a robot, expected one of --record"));
}

TEST_F(Replay, RefusesToRecordOverWhatItReads) {
  drive_and_look(*recorded().backend);
  for (const auto& [hal, camera] :
       {std::pair{"replay:" + file_ + "?mode=lenient", std::string("none")},
        {"sim", "frames:" + file_ + "?end=loop"}}) {
    const Config config =
        rig_config({{"hal", hal}, {"camera", camera}, {"record", file_}, {"fast", "true"}});
    try {
      open_backend({config, log_});
      FAIL() << hal;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("reads; expected another file"));
    }
  }
  EXPECT_EQ(complaint(), "") << "it is still there";
}

TEST_F(Replay, KeepsTheFramesOfTheProgramOnTheSameClock) {
  {
    const Rig rig = recorded();
    rig.wait(0.5);
    ASSERT_NE(rig.backend->frame_sink(), nullptr);
    camera::Frame frame = camera::make_frame(4, 2, camera::PixelFormat::Rgb24);
    frame.time = std::chrono::milliseconds(480);
    frame.sequence = 7;
    rig.backend->frame_sink()->take(frame);
    static_cast<void>(rig.backend->compass()->read());
    rig.backend->stop();
    rig.backend->frame_sink()->take(frame);  // too late, and no harm
  }
  const camera::FrameReader frames(file_);
  ASSERT_EQ(frames.frames().size(), 1U);
  EXPECT_EQ(frames.frames()[0].given, read_recording(file_).exchanges.at(0).time);
  EXPECT_EQ(frames.frames()[0].taken, std::chrono::milliseconds(480));
  EXPECT_EQ(frames.frames()[0].sequence, 7U);
}

TEST_F(Replay, FramesAreNotKeptWhereTheyAreNotWanted) {
  Rig rig = lockstep_rig(facing(1.0));
  const auto backend = with_recording(std::move(rig.backend), file_, *rig.log, {}, std::nullopt);
  EXPECT_EQ(backend->frame_sink(), nullptr);
}

TEST_F(Replay, RefusesOtherOptions) {
  EXPECT_THAT(complaint("?mode=wild"), HasSubstr("found 'mode=wild', expected mode=strict"));
  EXPECT_THAT(complaint("?speed=2"), HasSubstr("found 'speed=2', expected mode=strict"));
}

TEST_F(Replay, RefusesToRecordWhereNothingCanBeWritten) {
  const Config config = rig_config({{"fast", "true"}, {"record", "/no/such/folder/run.ebrec"}});
  try {
    open_backend({config, log_});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--record: cannot write /no/such/folder/run.ebrec"));
  }
}

TEST(Numbers, AreReadAsTheyWereWritten) {
  const Values values = {0.1, -0.0, 1e300, 5e-324, 3.0};
  EXPECT_EQ(read_numbers(write_numbers(values)), values);
  EXPECT_EQ(read_numbers(""), Values{});
  for (const char* wrong : {" ", "1 ", " 1", "1  2", "1,2", "x", "1e999"}) {
    EXPECT_FALSE(read_numbers(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace eyebridge::hal
