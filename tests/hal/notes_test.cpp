// What is noted of a program's calls, for people to look at.
#include <algorithm>
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/hal/device_notes.hpp"
#include "fault/fault_injector.hpp"
#include "host/host_backend.hpp"
#include "host/host_sound.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

class Notes : public ::testing::Test {
 protected:
  void open(std::unique_ptr<Backend> inner) {
    NotedBackend noted = with_notes(std::move(inner));
    robot_ = std::move(noted.backend);
    notes_ = std::move(noted.notes);
  }
  void SetUp() override {
    rig_ = lockstep_rig(facing(1.0));
    HostDevices devices;
    devices.sound = make_silent_sound(rig_.backend->clock());
    open(with_host(std::move(rig_.backend), std::move(devices)));
  }
  [[nodiscard]] Note note(const std::string& kind, int id, Quantity quantity) const {
    for (const NotedValue& value : notes_->values()) {
      if (value.kind == kind && value.id == id && value.quantity == quantity) {
        return value.cell.get().value();
      }
    }
    ADD_FAILURE() << kind << " " << id << " has no row";
    return {};
  }

  Rig rig_;
  std::unique_ptr<Backend> robot_;
  std::shared_ptr<DeviceNotes> notes_;
};

TEST_F(Notes, HaveARowForEachDeviceAndAreEmptyUntilTheProgramAsks) {
  EXPECT_GT(notes_->values().size(), 40U);
  for (const NotedValue& value : notes_->values()) {
    EXPECT_EQ(value.cell.get().value().count, 0U) << value.kind << " " << value.id;
  }
  EXPECT_EQ(notes_->sound().count, 0U);
}

TEST_F(Notes, AreWhatTheProgramReadAndWhen) {
  robot_->clock().wait_until(from_seconds(1.5));
  const double front = robot_->range_sensor(1)->read().value();
  const Note read = note("psd", 1, Quantity::Distance);
  EXPECT_EQ(read.values[0], front);
  EXPECT_EQ(read.count, 1U);
  EXPECT_FALSE(read.has_failed);
  EXPECT_EQ(notes_->time_of(read.stamp), from_seconds(1.5));
  EXPECT_EQ(note("psd", 2, Quantity::Distance).count, 0U) << "nobody has asked that one";

  const double heading = robot_->compass()->read().value();
  EXPECT_EQ(note("compass", 1, Quantity::Heading).values[0], heading);
  ASSERT_TRUE(robot_->drive()->set_speed({0.1, 0.5}));
  robot_->clock().wait_until(from_seconds(2.5));
  const double rate = robot_->gyroscope()->read().value();
  EXPECT_EQ(note("gyroscope", 1, Quantity::TurnRate).values[0], rate);
  const Vec2 felt = robot_->accelerometer()->read().value();
  EXPECT_NE(felt.y, 0.0);
  const Note acceleration = note("accelerometer", 1, Quantity::Acceleration);
  EXPECT_EQ(acceleration.values[0], felt.x);
  EXPECT_EQ(acceleration.values[1], felt.y);
  ASSERT_TRUE(robot_->encoder(1)->read());
  EXPECT_EQ(note("encoder", 1, Quantity::Ticks).count, 1U);
  ASSERT_TRUE(robot_->bumper(1)->read());
  EXPECT_EQ(note("bumper", 1, Quantity::Switch).values[0], 0.0);
  ASSERT_TRUE(robot_->digital()->write(9, true));
  EXPECT_EQ(note("digital", 9, Quantity::WrittenLevel).values[0], 1.0);
  EXPECT_FALSE(robot_->digital()->write(17, true)) << "there is none, and no row for it";
  EXPECT_FALSE(robot_->digital()->read(0));
  EXPECT_FALSE(robot_->analog()->read(9));
  ASSERT_TRUE(robot_->analog()->supply_voltage());
  EXPECT_GT(note("analog", 0, Quantity::Voltage).values[0], 0.0);
}

TEST_F(Notes, AreWhatTheProgramWanted) {
  Drive& drive = *robot_->drive();
  ASSERT_TRUE(drive.start({0.3, 0.0, 0.1}));
  const Note goal = note("drive", 1, Quantity::Goal);
  EXPECT_EQ(goal.values, (NoteCell::Values{0.3, 0.0, 0.1}));
  robot_->clock().wait_until(from_seconds(1.0));
  const DriveStatus status = drive.status().value();
  EXPECT_EQ(note("drive", 1, Quantity::Progress).values[1], status.remaining);
  const Pose pose = drive.odometry().value();
  EXPECT_EQ(note("drive", 1, Quantity::Pose).values[0], pose.x);
  ASSERT_TRUE(drive.set_speed({0.1, 0.5}));
  EXPECT_EQ(note("drive", 1, Quantity::WantedSpeed).values[1], 0.5);
  ASSERT_TRUE(robot_->motor(2)->set_duty(-0.25));
  EXPECT_EQ(note("motor", 2, Quantity::Duty).values[0], -0.25);
  ASSERT_TRUE(robot_->servo(1)->set(0.75));
  EXPECT_EQ(note("servo", 1, Quantity::Position).values[0], 0.75);
}

TEST_F(Notes, KeepTheNearestZoneOfARangeMatrix) {
  const RangeMatrix::Ranges ranges = robot_->range_matrix(3)->read().value();
  const auto nearest = std::ranges::min_element(ranges) - ranges.begin();
  const Note seen = note("tof", 3, Quantity::Nearest);
  EXPECT_EQ(seen.values[0], *std::ranges::min_element(ranges));
  // Of eight columns over 45 degrees, the left-most first, the middle.
  EXPECT_NEAR(seen.values[1], deg_to_rad(22.5 - 5.625 * (static_cast<double>(nearest % 8) + 0.5)),
              1e-9);
}

TEST_F(Notes, KeepTheNearestPointOfAScan) {
  Lidar& lidar = *robot_->lidar();
  for (const double field_of_view : {deg_to_rad(90), 2 * kPi}) {
    ASSERT_TRUE(lidar.configure(field_of_view, 0.0, 4));
    std::vector<double> ranges(4);
    ASSERT_TRUE(lidar.read(ranges));
    const Note nearest = note("lidar", 1, Quantity::Nearest);
    EXPECT_EQ(nearest.values[0], *std::ranges::min_element(ranges));
    EXPECT_LE(std::abs(nearest.values[1]), field_of_view / 2);
  }
  // The robot looks along +x in the middle between two walls: of a circle of four, the rays are
  // behind, left, ahead and right.
  std::vector<double> ranges(4);
  ASSERT_TRUE(lidar.read(ranges));
  const auto nearest = std::ranges::min_element(ranges) - ranges.begin();
  const std::vector<double> bearings{kPi, kPi / 2, 0.0, -kPi / 2};
  EXPECT_NEAR(note("lidar", 1, Quantity::Nearest).values[1],
              bearings[static_cast<std::size_t>(nearest)], 1e-9);
}

TEST_F(Notes, TellSounds) {
  ASSERT_TRUE(robot_->sound()->tone(440, 0.5));
  EXPECT_EQ(notes_->sound().frequency, 440);
  EXPECT_EQ(notes_->sound().length, 0.5);
  EXPECT_FALSE(robot_->sound()->play("/nowhere.wav"));
  EXPECT_EQ(notes_->sound().count, 1U) << "that one cannot be heard";
}

TEST_F(Notes, SayThatTheLastCallFailedAndKeepWhatWasReadBefore) {
  Rig rig = lockstep_rig(facing(1.0));
  FaultScript script = parse_fault_script("psd:1 lose @2s", {});
  open(with_faults(std::move(rig.backend), std::move(script), 1));
  const double front = robot_->range_sensor(1)->read().value();
  robot_->clock().wait_until(from_seconds(3.0));
  ASSERT_FALSE(robot_->range_sensor(1)->read());
  const Note lost = note("psd", 1, Quantity::Distance);
  EXPECT_TRUE(lost.has_failed);
  EXPECT_EQ(lost.values[0], front);
  EXPECT_EQ(lost.count, 2U);
}

TEST_F(Notes, StampWallTimeWhereTimeIsReal) {
  Rig rig = sim_rig(facing(1.0), {});
  open(std::move(rig.backend));
  // The coarse clock lags by one tick of the kernel, and the world's steps are 10 ms. A computer
  // that is too busy lets the robot's clock slip between reading and looking: then once more.
  const auto stamped = [&] {
    robot_->clock().wait_until(robot_->clock().now() + std::chrono::milliseconds(50));
    const Time before = robot_->clock().now();
    EXPECT_TRUE(robot_->range_sensor(1)->read());
    const Time after = robot_->clock().now();
    const Time noted = notes_->time_of(note("psd", 1, Quantity::Distance).stamp);
    return noted >= before - std::chrono::milliseconds(25) && noted <= after;
  };
  bool is_right = false;
  for (int i = 0; i < 20 && !is_right; ++i) is_right = stamped();
  EXPECT_TRUE(is_right);
}

TEST(NoteCells, AreNeverSeenHalfWritten) {
  NoteCell cell;
  std::atomic<bool> ends = false;
  const auto write = [&](double from) {
    for (double value = from; !ends; value += 2) {
      cell.put(Time(static_cast<Time::rep>(value)), {value, value, value, value});
    }
  };
  std::thread first(write, 0.0);
  std::thread second(write, 1.0);
  int seen = 0;
  bool whole = true;
  while (seen < 20000 && whole) {
    const std::optional<Note> note = cell.get();
    if (!note) continue;
    ++seen;
    for (const double value : note->values) whole = whole && value == note->values[0];
    whole = whole && static_cast<double>(note->stamp.count()) == note->values[0];
  }
  ends = true;
  first.join();
  second.join();
  EXPECT_TRUE(whole);
}

}  // namespace
}  // namespace eyebridge::hal
