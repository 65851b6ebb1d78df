// A robot program's devices on an IO7 board.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "board_peer.hpp"

namespace eyebridge::hal::testing {
namespace {

using ::testing::HasSubstr;

class BoardIo7 : public ::testing::Test, protected BoardPeer {
 protected:
  void open(const BoardTables& tables = default_board_tables()) {
    backend = make_backend(tables);
    ASSERT_NE(backend, nullptr);
    told.clear();
  }

  std::unique_ptr<BoardBackend> backend;
};

TEST_F(BoardIo7, HasWhatTheBoardListsAndNothingElse) {
  open();
  EXPECT_NE(backend->range_sensor(6), nullptr);
  EXPECT_EQ(backend->range_sensor(7), nullptr);
  EXPECT_NE(backend->motor(4), nullptr);
  EXPECT_EQ(backend->motor(5), nullptr);
  EXPECT_NE(backend->encoder(4), nullptr);
  EXPECT_NE(backend->servo(14), nullptr);
  EXPECT_EQ(backend->servo(0), nullptr);
  EXPECT_EQ(backend->motor(1), backend->motor(1));
  EXPECT_EQ(backend->lidar(), nullptr);
  EXPECT_EQ(backend->world(), nullptr);
  EXPECT_EQ(backend->camera_view(), nullptr);
  EXPECT_EQ(backend->compass(), nullptr);
  EXPECT_EQ(backend->gyroscope(), nullptr);
  EXPECT_EQ(backend->accelerometer(), nullptr);
  EXPECT_EQ(backend->robot_id(), 1);
}

TEST_F(BoardIo7, HasNoDeviceWhoseLetterIsMissing) {
  BoardPeer small("M");
  const auto other = small.make_backend(default_board_tables());
  ASSERT_NE(other, nullptr);
  EXPECT_EQ(other->encoder(1), nullptr);
  EXPECT_EQ(other->servo(1), nullptr);
  EXPECT_EQ(other->drive(), nullptr);
  EXPECT_NE(other->motor(1), nullptr);
}

TEST_F(BoardIo7, ReadsRangesThroughTheTable) {
  BoardTables tables = default_board_tables();
  tables.psds = {{2, {1.0, 0.5, 0.0}}};
  open(tables);
  EXPECT_EQ(backend->range_sensor(1), nullptr);
  EXPECT_EQ(backend->range_sensor(2)->read_raw().value(), 512);
  EXPECT_NEAR(backend->range_sensor(2)->read().value(), 1.0 - 0.5 * 512 * 2 / 4095, 1e-9);
  EXPECT_EQ(backend->range_sensor(2)->out_of_range(), 9.999);
}

TEST_F(BoardIo7, MotorsSpeakTheBoardsUnits) {
  BoardTables tables = default_board_tables();
  tables.drive.right_reversed = true;
  open(tables);
  ASSERT_TRUE(backend->motor(1)->set_duty(0.5));
  ASSERT_TRUE(backend->motor(2)->set_duty(0.5));
  ASSERT_TRUE(backend->motor(1)->set_speed(400));
  ASSERT_TRUE(backend->motor(2)->set_speed(1e9));
  ASSERT_TRUE(backend->motor(3)->set_pid(1, 2, 3));
  ASSERT_TRUE(backend->servo(14)->set(0.5));
  EXPECT_EQ(told, "m 1 50\rm 2 -50\rM 1 4\rM 2 -128\rd 3 1 2 3\rs 14 128\r");
}

TEST_F(BoardIo7, ArgumentsThatADeviceCannotTakeAreOutOfRangeAndNotSent) {
  open();
  const double nan = std::nan("");
  EXPECT_EQ(backend->motor(1)->set_duty(1.01).error().code, Errc::OutOfRange);
  EXPECT_EQ(backend->motor(1)->set_duty(nan).error().code, Errc::OutOfRange);
  EXPECT_EQ(backend->motor(1)->set_speed(nan).error().code, Errc::OutOfRange);
  EXPECT_EQ(backend->motor(1)->set_pid(4, 256, 1).error().code, Errc::OutOfRange);
  EXPECT_EQ(backend->servo(1)->set(-0.01).error().code, Errc::OutOfRange);
  EXPECT_EQ(told, "");
}

TEST_F(BoardIo7, EncodersCountFromTheStartAndOverTheEndOf16Bits) {
  encoder[1] = 65000;
  open();
  EXPECT_EQ(backend->encoder(1)->read().value(), 0);
  for (int i = 0; i < 100; ++i) {
    encoder[1] += 1000;
    live(*backend, 300ms);
  }
  EXPECT_EQ(backend->encoder(1)->read().value(), 100'000);
  ASSERT_TRUE(backend->encoder(1)->reset());
  encoder[1] -= 7;
  clock.spend(10ms);
  EXPECT_EQ(backend->encoder(1)->read().value(), -7);
}

TEST_F(BoardIo7, AFlippedBitInACountIsAskedAgain) {
  open();
  encoder[1] = 50;
  flip = 0x4000;
  EXPECT_EQ(backend->encoder(1)->read().value(), 50);
}

TEST_F(BoardIo7, ALostBoardIsAnErrorAndItsCountsGoOnWhenItIsBack) {
  open();
  encoder[1] = 500;
  live(*backend, 2s);
  line->gone = true;
  EXPECT_EQ(backend->encoder(1)->read().error().code, Errc::Disconnected);
  EXPECT_EQ(backend->range_sensor(1)->read().error().code, Errc::Disconnected);
  EXPECT_EQ(backend->motor(1)->set_duty(0.1).error().code, Errc::Disconnected);
  encoder[1] = 3;  // it has rebooted
  plug_in();
  live(*backend, 3s);
  EXPECT_EQ(backend->encoder(1)->read().value(), 500);
  EXPECT_THAT(line->sent, HasSubstr("m 1 0\rm 2 0\rm 3 0\rm 4 0\r"));
}

TEST_F(BoardIo7, ServoLimitsAndGainsAreToldAgainAfterARestart) {
  BoardTables tables = default_board_tables();
  tables.servos = {{2, {}, 70, 150}};
  backend = make_backend(tables);
  EXPECT_THAT(told, HasSubstr("S 2 70 150\r"));
  ASSERT_TRUE(backend->motor(1)->set_pid(4, 5, 6));
  line->gone = true;
  live(*backend, 300ms);
  told.clear();
  plug_in();
  live(*backend, 3s);
  EXPECT_THAT(told, HasSubstr("S 2 70 150\r"));
  EXPECT_THAT(told, HasSubstr("d 1 4 5 6\r"));
}

TEST_F(BoardIo7, StopStopsEveryMotor) {
  open();
  ASSERT_TRUE(backend->motor(1)->set_duty(0.5));
  ASSERT_TRUE(backend->motor(3)->set_duty(0.5));
  backend->stop();
  for (int id = 1; id <= 4; ++id) EXPECT_EQ(motor[id], 0) << id;
}

TEST_F(BoardIo7, ItsEndStopsEveryMotor) {
  open();
  ASSERT_TRUE(backend->motor(2)->set_duty(0.5));
  backend.reset();
  EXPECT_EQ(motor[2], 0);
}

TEST_F(BoardIo7, AnIdleBoardHearsFromUsMoreOftenThanItsWatchdogWaits) {
  open();
  for (int i = 0; i < 10; ++i) {
    const std::size_t before = line->sent.size();
    live(*backend, 250ms);
    EXPECT_GT(line->sent.size(), before);
  }
}

TEST_F(BoardIo7, LinesArePortsFromZeroAndAreToldAgainAfterARestart) {
  BoardPeer peer("M e c o");
  const auto robot = peer.make_backend(default_board_tables());
  ASSERT_NE(robot->digital(), nullptr);
  EXPECT_EQ(robot->digital()->read_all().error().code, Errc::Unsupported);  // no letter I
  peer.told.clear();
  ASSERT_TRUE(robot->digital()->setup(16, LineMode::Input));
  ASSERT_TRUE(robot->digital()->setup(1, LineMode::Output));
  ASSERT_TRUE(robot->digital()->write(1, true));
  EXPECT_EQ(peer.told, "c 15 i\rc 0 o\ro 0 1\r");
  peer.line->gone = true;
  peer.live(*robot, 300ms);
  EXPECT_EQ(robot->digital()->write(2, true).error().code, Errc::Disconnected);
  peer.told.clear();
  peer.plug_in();
  peer.live(*robot, 3s);
  EXPECT_THAT(peer.told, HasSubstr("o 0 1\rc 0 o\r"));
  EXPECT_THAT(peer.told, HasSubstr("o 1 1\r"));
  EXPECT_THAT(peer.told, HasSubstr("c 15 i\r"));
}

TEST_F(BoardIo7, KnowsItsVersionAndItsVoltage) {
  open();
  EXPECT_EQ(backend->io_board()->version().value(), board.version);
  EXPECT_NEAR(backend->analog()->supply_voltage().value(), board.battery_cv / 100.0, 1e-9);
  EXPECT_EQ(backend->analog()->read(0).value(), board.analog_0);
  EXPECT_EQ(backend->digital(), nullptr);
  EXPECT_EQ(backend->remote(), nullptr);
  EXPECT_EQ(backend->radio(), nullptr);
  EXPECT_EQ(backend->sound(), nullptr);
  EXPECT_EQ(backend->serial_port(0), nullptr);
}

}  // namespace
}  // namespace eyebridge::hal::testing
