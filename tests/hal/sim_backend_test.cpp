// What only the simulated backend promises: reproducible runs, messages, threads.
#include <atomic>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/hash.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/hal/environment.hpp"
#include "rigs.hpp"
#include "shared/open_only.hpp"
#include "sim/sim_world.hpp"

namespace eyebridge::hal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Rig open(const std::map<std::string, std::string>& flags, files::Scenario scenario) {
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  const Config config = rig_config(flags);
  rig.backend = open_scenario(std::move(scenario), {"room.wld"}, {config, *rig.log});
  return rig;
}

/// A room whose robot has noisy sensors and wheels.
files::Scenario noisy_scenario() {
  files::Scenario scenario = rig_scenario(1.5);
  robot::RobotModel& model = scenario.models.front();
  for (auto& sensor : model.range_sensors) sensor.error.sigma = 0.01;
  model.drive_error.linear_sigma = 0.05;
  model.drive_error.angular_sigma = 0.05;
  return scenario;
}

class HashingTrace final : public TraceSink {
 public:
  void point(const TracePoint& point) noexcept override {
    hash_.add(static_cast<std::uint64_t>(point.time.count()));
    for (const double value : {point.pose.x, point.pose.y, point.pose.theta, point.odometry.x}) {
      hash_.add(value);
    }
    for (const double range : point.ranges) hash_.add(range);
  }
  [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

 private:
  StateHash hash_;
};

struct CountingTrace final : TraceSink {
  void point(const TracePoint&) noexcept override { ++count; }
  int count = 0;
};

/// What a small program reads in a noisy world, as a hash.
std::uint64_t run_program(const std::string& seed, TraceSink* trace) {
  const Rig rig = open({{"fast", "true"}, {"seed", seed}}, noisy_scenario());
  rig.backend->trace_to(trace);
  StateHash readings;
  for (int leg = 0; leg < 4; ++leg) {
    EXPECT_TRUE(rig.backend->drive()->start({0.3, kPi / 2, 0.3}));
    while (rig.backend->drive()->status().value().progress == DriveProgress::Driving) {
      readings.add(rig.backend->range_sensor(1)->read().value());
      rig.wait(0.01);
    }
  }
  rig.backend->trace_to(nullptr);
  const Pose end = rig.backend->world()->robot_pose(0).value();
  readings.add(end.x);
  readings.add(end.y);
  return readings.value();
}

files::Scenario scenario_with(robot::DriveKind kind) {
  files::Scenario scenario = rig_scenario(1.5);
  scenario.models.front().drive.kind = kind;
  return scenario;
}

std::vector<std::string> names_of(const std::vector<DeviceFacts>& facts) {
  std::vector<std::string> names;
  for (const DeviceFacts& device : facts) names.push_back(device.name);
  return names;
}

TEST(SimBackend, HasTheMotorsOfItsKindOfDrive) {
  const Rig omni = open({{"fast", "true"}}, scenario_with(robot::DriveKind::Omni));
  EXPECT_NE(omni.backend->motor(4), nullptr);
  EXPECT_EQ(omni.backend->motor(5), nullptr);
  EXPECT_THAT(names_of(omni.backend->facts_of("motor")),
              ElementsAre("MOTOR_FL", "MOTOR_FR", "MOTOR_BL", "MOTOR_BR"));
  EXPECT_THAT(names_of(omni.backend->facts_of("encoder")),
              ElementsAre("QUAD_FL", "QUAD_FR", "QUAD_BL", "QUAD_BR"));
  for (const int id : {1, 2, 3, 4}) {
    ASSERT_TRUE(omni.backend->motor(id)->set_duty(id == 2 || id == 3 ? 0.1 : -0.1));
  }
  omni.wait(0.5);
  EXPECT_GT(omni.backend->drive()->odometry().value().y, 0.05);
  EXPECT_NEAR(omni.backend->drive()->odometry().value().x, 0.0, 1e-9);
  EXPECT_GT(omni.backend->encoder(3)->read().value(), 100);

  const Rig car = open({{"fast", "true"}}, scenario_with(robot::DriveKind::Ackermann));
  EXPECT_NE(car.backend->motor(1), nullptr);
  EXPECT_EQ(car.backend->motor(2), nullptr);
  EXPECT_NE(car.backend->encoder(2), nullptr);
  EXPECT_NE(car.backend->servo(1), nullptr);

  const Rig three = open({{"fast", "true"}}, scenario_with(robot::DriveKind::Swedish));
  EXPECT_NE(three.backend->encoder(3), nullptr);
  EXPECT_EQ(three.backend->motor(4), nullptr);
}

TEST(SimBackend, RepeatsARunOfTheSameSeedBitForBit) {
  HashingTrace first;
  HashingTrace second;
  EXPECT_EQ(run_program("7", &first), run_program("7", &second));
  EXPECT_EQ(first.value(), second.value());
}

TEST(SimBackend, VariesWithTheSeed) {
  EXPECT_NE(run_program("7", nullptr), run_program("8", nullptr));
}

TEST(SimBackend, IsNotDisturbedByATrace) {
  HashingTrace trace;
  EXPECT_EQ(run_program("7", nullptr), run_program("7", &trace));
}

TEST(SimBackend, WarnsOfACollisionOnceAContact) {
  const Rig rig = open({{"fast", "true"}}, rig_scenario(0.2));
  ASSERT_TRUE(rig.backend->drive()->set_speed({0.3, 0.0}));
  rig.wait(3.0);
  // The rim touches the wall at x = 3 when the centre is a radius away.
  EXPECT_THAT(rig.log->messages(Severity::Warning),
              ElementsAre(HasSubstr("robot 1 hit a wall at x=2.907 y=1.000")));
}

// 0.6 - 0.46 is not 0.14 to the last bit.
TEST(SimBackend, ASubmarineAtTheSurfaceIsNotOutOfTheWater) {
  KeepingLog log;
  files::Scenario scenario = files::default_scenario();
  scenario.models[0] = *files::builtin_robot("Mako");
  scenario.world.water = 0.6;
  SimWorld world(scenario, {}, log);
  world.set_altitude(0, 0.14);
  EXPECT_TRUE(log.messages(Severity::Warning).empty());
  world.set_altitude(0, 0.15);
  EXPECT_THAT(log.messages(Severity::Warning), ElementsAre(HasSubstr("is out of the water")));
}

/// Keeps the contacts of a run, as text.
class KeepingContacts final : public TraceSink {
 public:
  void point(const TracePoint&) noexcept override {}
  void contact(const TraceContact& c) noexcept override {
    rows.push_back(std::string(c.robot) + " " + std::string(c.with));
    times.push_back(c.time);
  }
  std::vector<std::string> rows;
  std::vector<Time> times;
};

TEST(SimBackend, TellsItsTraceOfItsOwnContactsAndTheLogOfPushesAsInfo) {
  files::Scenario scenario = rig_scenario(0.5);
  world::ObjectSpec can;
  can.kind = world::ObjectKind::Can;
  can.pose = {scenario.robots[0].pose.x + 0.2, scenario.robots[0].pose.y, 0};
  scenario.world.objects.insert(scenario.world.objects.begin(), can);
  const Rig rig = open({{"fast", "true"}}, std::move(scenario));
  KeepingContacts contacts;
  rig.backend->trace_to(&contacts);
  ASSERT_TRUE(rig.backend->drive()->set_speed({0.3, 0.0}));
  rig.wait(1.0);
  rig.backend->trace_to(nullptr);
  ASSERT_THAT(contacts.rows, ElementsAre("robot 1 object 1"));
  EXPECT_GT(contacts.times[0], Time{0});
  EXPECT_LT(contacts.times[0], from_seconds(1.0));
  EXPECT_THAT(rig.log->messages(Severity::Info),
              testing::Contains(HasSubstr("robot 1 hit object 1")));
  EXPECT_THAT(rig.log->messages(Severity::Warning), testing::IsEmpty());
}

TEST(SimBackend, SaysThatItDrivesTheFirstOfSeveralRobots) {
  const Rig rig = open({{"fast", "true"}}, rig_scenario(0.5));
  EXPECT_THAT(
      rig.log->messages(Severity::Info),
      ElementsAre("this program drives robot 1 of 2, the others stand still; all have one with "
                  "--robots all"));
  rig.wait(1.0);
  EXPECT_EQ(rig.backend->world()->robot_pose(2).value(), (Pose{3.5, 1.5, kPi}));
}

TEST(SimBackend, PassesOnTheWarningsOfItsFiles) {
  files::Scenario scenario = rig_scenario(0.5);
  scenario.robots.resize(1);
  scenario.start_paused = true;
  scenario.warnings.push_back({{"room.wld", 3, 1}, "odd wall"});
  const Rig rig = open({{"fast", "true"}}, std::move(scenario));
  EXPECT_THAT(rig.log->messages(Severity::Warning), ElementsAre("room.wld:3:1: odd wall"));
  EXPECT_TRUE(rig.backend->environment()->starts_paused());
}

TEST(SimBackend, RefusesAWorldWithoutARobot) {
  files::Scenario scenario = rig_scenario(0.5);
  scenario.robots.clear();
  EXPECT_THAT([&] { open({}, scenario); }, testing::ThrowsMessage<ConfigError>(
                                               "room.wld: found no robot, expected at least one"));
}

TEST(SimBackend, RefusesARobotThatStandsInAWall) {
  files::Scenario scenario = rig_scenario(0.5);
  scenario.robots.front().pose = {3.0, 1.0, 0.0};
  EXPECT_THAT([&] { open({}, scenario); },
              testing::ThrowsMessage<ConfigError>(HasSubstr("room.wld: ")));
}

TEST(SimBackend, HasOnlyTheDevicesOfItsModel) {
  files::Scenario scenario = rig_scenario(0.5);
  scenario.models.front() = robot::RobotModel{};
  const Rig rig = open({{"fast", "true"}}, std::move(scenario));
  EXPECT_EQ(rig.backend->range_sensor(1), nullptr);
  EXPECT_EQ(rig.backend->proximity(1), nullptr);
  EXPECT_EQ(rig.backend->bumper(1), nullptr);
  EXPECT_EQ(rig.backend->lidar(), nullptr);
  EXPECT_EQ(rig.backend->camera_view(), nullptr);
  EXPECT_NE(rig.backend->drive(), nullptr);
}

TEST(SimBackend, TakesTheStepFromTheConfiguration) {
  for (const auto& [step, points] : {std::pair{"1ms", 1000}, std::pair{"0.1", 10}}) {
    const Rig rig = open({{"fast", "true"}, {"step", step}}, rig_scenario(0.5));
    CountingTrace trace;
    rig.backend->trace_to(&trace);
    rig.backend->clock().wait_until(from_seconds(1.0));
    EXPECT_EQ(trace.count, points) << step;
  }
}

TEST(SimBackend, TakesTheStallTimeoutFromTheConfiguration) {
  const auto seconds_until_failure = [](const std::string& timeout) {
    const Rig rig = open({{"fast", "true"}, {"stall_timeout", timeout}}, rig_scenario(0.1));
    EXPECT_TRUE(rig.backend->drive()->start({1.0, 0.0, 0.3}));
    EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Failed);
    return to_seconds(rig.backend->clock().now());
  };
  EXPECT_NEAR(seconds_until_failure("5s") - seconds_until_failure("1s"), 4.0, 0.05);
}

TEST(SimBackend, GivesTheCameraTheNoiseAndTexturesOfItsScenario) {
  files::Scenario scenario = rig_scenario(0.5);
  scenario.models.front().camera->error.sigma = 3.0;
  scenario.models.front().camera->error.salt_and_pepper = 0.01;
  scenario.directory = "/tmp/textures";
  const Rig rig = open({{"fast", "true"}, {"seed", "5"}}, std::move(scenario));
  const camera::ImageNoise noise = rig.backend->camera_view()->noise();
  EXPECT_EQ(noise.error.sigma, 3.0);
  EXPECT_EQ(noise.error.salt_and_pepper, 0.01);
  EXPECT_NE(noise.seed, 5u);  // which the other devices draw from
  EXPECT_EQ(rig.backend->camera_view()->texture_directory(), "/tmp/textures");
}

/// Uses everything there is until the clock shows `end`.
void use_all_devices(Backend& backend, Time end) {
  std::vector<double> ranges(8);
  while (backend.clock().now() < end) {
    EXPECT_TRUE(backend.drive()->status());
    EXPECT_TRUE(backend.drive()->odometry());
    EXPECT_TRUE(backend.drive()->set_speed({0.1, 0.5}));
    EXPECT_TRUE(backend.range_sensor(1)->read());
    EXPECT_TRUE(backend.proximity(1)->read());
    EXPECT_TRUE(backend.bumper(1)->read());
    EXPECT_TRUE(backend.lidar()->read(ranges));
    EXPECT_TRUE(backend.compass()->read());
    EXPECT_TRUE(backend.gyroscope()->read());
    EXPECT_TRUE(backend.accelerometer()->read());
    EXPECT_TRUE(backend.motor(2)->set_duty(0.1));
    EXPECT_TRUE(backend.encoder(1)->read());
    EXPECT_TRUE(backend.servo(1)->set(0.3));
    EXPECT_TRUE(backend.world()->robot_pose(0));
    EXPECT_EQ(backend.camera_view()->scene().bodies.size(), 3u);
    EXPECT_GT(backend.camera_view()->eye().z, 0.0);
    backend.clock().wait_until(backend.clock().now() + from_seconds(0.01));
  }
}

void use_from_several_threads(const std::map<std::string, std::string>& flags) {
  const Rig rig = open(flags, noisy_scenario());
  HashingTrace trace;
  rig.backend->trace_to(&trace);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] { use_all_devices(*rig.backend, from_seconds(3.0)); });
  }
  for (std::thread& thread : threads) thread.join();
  rig.backend->stop();
  rig.backend->trace_to(nullptr);
  EXPECT_NE(trace.value(), HashingTrace{}.value());
}

TEST(SimBackend, LetsSeveralThreadsUseItInRealTime) {
  use_from_several_threads({{"factor", "100"}});
}

TEST(SimBackend, LetsSeveralThreadsUseItInLockstep) {
  use_from_several_threads({{"fast", "true"}});
}

}  // namespace
}  // namespace eyebridge::hal
