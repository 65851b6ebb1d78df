// Sound, radio, serial ports, lines and inputs behind faults, in recordings, and from them.
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clock/lockstep_clock.hpp"
#include "eyebridge/hal/registry.hpp"
#include "fault/fault_injector.hpp"
#include "host/host_backend.hpp"
#include "host/host_sound.hpp"
#include "radio/radio_medium.hpp"
#include "replay/recorder.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A serial port whose other end answers "ok" to everything.
class Echoing final : public SerialPort {
 public:
  Result<void> open(int, bool) override { return {}; }
  Result<void> send(std::span<const std::uint8_t> bytes) override {
    sent_.append(bytes.begin(), bytes.end());
    waiting_ += "ok";
    return {};
  }
  Result<std::size_t> receive(std::span<std::uint8_t> buffer, Time) override {
    const std::size_t count = std::min(buffer.size(), waiting_.size());
    std::copy_n(waiting_.begin(), count, buffer.begin());
    waiting_.erase(0, count);
    return count;
  }
  Result<std::size_t> pending() override { return waiting_.size(); }
  Result<void> flush() override {
    waiting_.clear();
    return {};
  }
  Result<void> close() override { return {}; }

 private:
  std::string sent_;
  std::string waiting_;
};

/// The rigs' robot with a radio that another robot, 2, answers, and a port that answers.
class HostDevicesTest : public ::testing::Test {
 protected:
  HostDevicesTest() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    file_ = ::testing::TempDir() + "/host_" + info->name() + ".ebrec";
  }
  ~HostDevicesTest() override {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file_ + end);
  }

  Rig robot() {
    Rig rig = lockstep_rig(facing(1.0));
    Clock& clock = rig.backend->clock();
    const auto medium = std::make_shared<RadioMedium>();
    other_ = make_medium_radio(medium, 2, {}, clock);
    EXPECT_TRUE(other_->start());
    HostDevices devices;
    devices.radio = make_medium_radio(medium, 1, {}, clock);
    devices.sound = make_silent_sound(clock);
    devices.serial_ports.emplace(0, std::make_unique<Echoing>());
    rig.backend = with_host(std::move(rig.backend), std::move(devices));
    return rig;
  }
  Rig recorded() {
    Rig rig = robot();
    rig.backend = with_recording(std::move(rig.backend), file_, *rig.log);
    return rig;
  }
  std::unique_ptr<Backend> replay(const std::string& options = "") {
    return open_backend({rig_config({{"hal", "replay:" + file_ + options}}), log_});
  }
  Rig broken(const std::string& script) {
    Rig rig = robot();
    rig.backend = with_faults(std::move(rig.backend), parse_fault_script(script, {}), 1);
    return rig;
  }

  /// Uses all of them; what came back. Robot 2 sends in between, where it is.
  std::vector<std::string> use(Backend& robot, Radio* other) {
    std::vector<std::string> seen;
    Radio& radio = *robot.radio();
    EXPECT_TRUE(radio.start());
    EXPECT_TRUE(radio.send(2, "to you"));
    if (other != nullptr) {
      EXPECT_TRUE(other->send(1, "to me"));
    }
    const auto message = must(radio.receive());
    seen.push_back(message ? std::to_string(message->sender) + message->text : "none");
    seen.push_back(must(radio.receive()) ? "more" : "none");
    for (const int id : must(radio.robots())) seen.push_back(std::to_string(id));

    SerialPort& port = *robot.serial_port(0);
    const std::string text = "hi\xFF";
    EXPECT_TRUE(port.open(9600, false));
    EXPECT_TRUE(port.send({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
    seen.push_back(std::to_string(must(port.pending())));
    std::vector<std::uint8_t> buffer(8);
    const std::size_t count = must(port.receive(buffer, Time{0}));
    seen.emplace_back(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count));
    EXPECT_TRUE(port.flush());
    EXPECT_TRUE(port.close());

    EXPECT_TRUE(robot.sound()->tone(1000, 0.1));
    seen.emplace_back(must(robot.sound()->is_playing()) ? "plays" : "silent");
    robot.clock().spend(200ms);
    seen.emplace_back(must(robot.sound()->is_playing()) ? "plays" : "silent");

    EXPECT_TRUE(robot.digital()->write(16, true));
    seen.push_back(std::to_string(must(robot.digital()->read_all())));
    seen.push_back(std::to_string(must(robot.digital()->read(3))));
    seen.push_back(std::to_string(must(robot.analog()->read(8))));
    seen.push_back(std::to_string(must(robot.analog()->supply_voltage())));
    EXPECT_TRUE(radio.stop());
    robot.stop();
    return seen;
  }

  std::string file_;
  KeepingLog log_;
  std::unique_ptr<Radio> other_;
};

const auto kSeen = ElementsAre("2to me", "none", "1", "2", "2", "ok", "plays", "silent", "33020",
                               "1", "2048", "7.400000");

TEST_F(HostDevicesTest, WorkBesideTheRobot) {
  const Rig rig = robot();
  EXPECT_THAT(use(*rig.backend, other_.get()), kSeen);
  EXPECT_EQ(must(other_->receive())->text, "to you");
}

TEST_F(HostDevicesTest, AnswerTheSameFromARecording) {
  {
    const Rig rig = recorded();
    EXPECT_THAT(use(*rig.backend, other_.get()), kSeen);
  }
  const auto again = replay();
  EXPECT_EQ(again->serial_port(1), nullptr);
  EXPECT_EQ(again->io_board(), nullptr);
  EXPECT_EQ(again->radio()->id(), 1);
  EXPECT_THAT(use(*again, nullptr), kSeen);
  EXPECT_TRUE(log_.messages(Severity::Error).empty());
}

TEST_F(HostDevicesTest, ALenientReplayGivesNoMessageTwice) {
  {
    const Rig rig = recorded();
    use(*rig.backend, other_.get());
  }
  const auto again = replay("?mode=lenient");
  ASSERT_TRUE(again->radio()->start());
  EXPECT_FALSE(must(again->radio()->receive()));
  std::uint8_t byte = 0;
  EXPECT_EQ(must(again->serial_port(0)->receive({&byte, 1}, Time{0})), 0u);
  EXPECT_EQ(must(again->analog()->read(8)), 2048);
  EXPECT_EQ(again->analog()->read(7).error().code, Errc::Unsupported);
}

TEST_F(HostDevicesTest, FailByTheScript) {
  const Rig rig = broken("radio lose; serial lose; sound lose; digital:3 lose; analog:8 lose");
  Backend& robot = *rig.backend;
  EXPECT_EQ(robot.radio()->start().error().code, Errc::Disconnected);
  EXPECT_EQ(robot.radio()->receive().error().code, Errc::Disconnected);
  EXPECT_EQ(robot.radio()->robots().error().code, Errc::Disconnected);
  EXPECT_EQ(robot.serial_port(0)->pending().error().code, Errc::Disconnected);
  EXPECT_EQ(robot.sound()->is_playing().error().code, Errc::Disconnected);
  EXPECT_THAT(robot.digital()->read(3).error().what, HasSubstr("digital:3 lose"));
  EXPECT_TRUE(robot.digital()->read(4));
  EXPECT_FALSE(robot.analog()->read(8));
  EXPECT_TRUE(robot.analog()->read(0));
}

TEST_F(HostDevicesTest, FrozenTheyTakeAndGiveNothing) {
  const Rig rig = broken("radio freeze @1s; serial freeze @1s");
  Backend& robot = *rig.backend;
  ASSERT_TRUE(robot.radio()->start());
  ASSERT_TRUE(other_->send(1, "before"));
  EXPECT_EQ(must(robot.radio()->receive())->text, "before");
  rig.wait(1.0);
  ASSERT_TRUE(other_->send(1, "after"));
  EXPECT_FALSE(must(robot.radio()->receive())) << "neither the new one nor the old one again";
  EXPECT_TRUE(robot.radio()->send(2, "lost"));
  EXPECT_FALSE(must(other_->receive()));
}

}  // namespace
}  // namespace eyebridge::hal
