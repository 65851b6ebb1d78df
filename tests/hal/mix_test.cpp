// Robots whose devices come from several backends.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calls/absent_robot.hpp"
#include "config/mix_text.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/hal/passing_backend.hpp"
#include "eyebridge/hal/registry.hpp"
#include "mix/mix_backend.hpp"
#include "rigs.hpp"
#include "shared/shared_sim.hpp"
#include "sim/sim_backend.hpp"

namespace eyebridge::hal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A simulated robot that says nothing of its world, like a real one.
class Worldless final : public PassingBackend {
 public:
  using PassingBackend::PassingBackend;
  [[nodiscard]] int robot_id() const override { return 1; }
  WorldControl* world() override { return nullptr; }
  camera::View* camera_view() override { return nullptr; }
  camera::Source* camera_source() override { return nullptr; }
};

/// Two simulated robots in virtual time, each before a wall of its own.
struct Two {
  Rig main = lockstep_rig(facing(1.0));
  Rig other = lockstep_rig(facing(0.5));
  Backend* other_backend = other.backend.get();

  /// The first one is as on a board.
  std::unique_ptr<Backend> mix_with_board(std::vector<std::string> devices) {
    main.backend = std::make_unique<Worldless>(std::move(main.backend));
    return mix(std::move(devices));
  }
  std::unique_ptr<Backend> mix(std::vector<std::string> devices) {
    std::vector<MixPart> parts;
    parts.push_back({std::move(devices), "other", std::move(other.backend)});
    return make_mix(std::move(main.backend), std::move(parts));
  }
};

void wait(Backend& backend, double seconds) {
  backend.clock().wait_until(backend.clock().now() + from_seconds(seconds));
}

TEST(Mix, TakesTheKindsThatAreNamedFromTheOtherBackendAndTheRestFromTheFirst) {
  Two two;
  const auto mix = two.mix({"psd", "compass"});
  EXPECT_NEAR(mix->range_sensor(1)->read().value(), 0.5, 1e-9);
  EXPECT_EQ(mix->range_sensor(9), nullptr);
  std::vector<double> scan(1);
  ASSERT_TRUE(mix->lidar()->configure(1.0, 0.0, 1));
  ASSERT_TRUE(mix->lidar()->read(scan));
  EXPECT_GT(scan[0], 0.9) << "the lidar is the first one's";
  EXPECT_NEAR(mix->compass()->read().value(), 0.0, 1e-9);
}

/// A robot whose messages suffer.
class Deaf final : public PassingBackend {
 public:
  using PassingBackend::PassingBackend;
  [[nodiscard]] RadioConditions radio_conditions() const override { return {0.5, Time(7)}; }
};

TEST(Mix, MessagesSufferWhatTheFirstBackendSays) {
  Two two;
  two.main.backend = std::make_unique<Deaf>(std::move(two.main.backend));
  const auto mix = two.mix({"psd"});
  EXPECT_EQ(mix->radio_conditions().loss, 0.5);
  EXPECT_EQ(mix->radio_conditions().delay, Time(7));
}

TEST(Mix, ASimulatedRobotThatDoesNotDriveFollowsTheOneThatDoes) {
  Two two;
  const auto mix = two.mix_with_board({"psd"});
  ASSERT_TRUE(mix->drive()->start({0.2, 0.0, 0.2}));
  wait(*mix, 5.0);
  EXPECT_NEAR(mix->range_sensor(1)->read().value(), 0.3, 0.01);
  const double there = mix->drive()->odometry().value().x;
  EXPECT_NEAR(two.other_backend->world()->robot_pose(0).value().x -
                  lockstep_rig(facing(0.5)).backend->world()->robot_pose(0).value().x,
              there, 1e-9);
}

TEST(Mix, AFirstRobotWhoseWheelsAreElsewhereFollowsThem) {
  Two two;
  const auto mix = two.mix({"drive", "motor", "encoder"});
  ASSERT_TRUE(mix->drive()->start({0.2, 0.0, 0.2}));
  wait(*mix, 5.0);
  EXPECT_NEAR(mix->range_sensor(1)->read().value(), 0.8, 0.01);
  EXPECT_NEAR(two.other_backend->drive()->odometry().value().x, 0.2, 0.01);
}

TEST(Mix, APartThatIsNotTheFirstRobotOfItsWorldBeginsWhereItStands) {
  NullLog log;
  const Config config = rig_config({{"fast", "true"}});
  const files::Scenario scenario = rig_scenario(0.5);
  const auto world = SharedSim::for_one(scenario, config, nullptr, log);
  Two two;
  two.other.backend = std::make_unique<SimBackend>(world->world(), world->clock_of(0),
                                                   world->view(), 1, 12.0, AtEnd::Stop, world);
  const auto mix = two.mix_with_board({"psd"});
  // It looks at the other side of the wall that the first one faces.
  const double wall = facing(0.0).x + kFrontOffset;
  const double distance = scenario.robots[1].pose.x - kFrontOffset - wall;
  EXPECT_NEAR(mix->range_sensor(1)->read().value(), distance, 1e-9);
}

TEST(Mix, NewOdometryDoesNotMoveTheFollower) {
  Two two;
  const auto mix = two.mix_with_board({"psd"});
  ASSERT_TRUE(mix->drive()->start({0.1, 0.0, 0.2}));
  wait(*mix, 5.0);
  const double before = mix->range_sensor(1)->read().value();
  ASSERT_TRUE(mix->drive()->set_odometry({7.0, -3.0, 1.5}));
  EXPECT_NEAR(mix->range_sensor(1)->read().value(), before, 1e-9);
  ASSERT_TRUE(mix->drive()->start({0.1, 0.0, 0.2}));
  wait(*mix, 5.0);
  EXPECT_NEAR(mix->range_sensor(1)->read().value(), before - 0.1, 0.01);
}

TEST(Mix, WhereBothAreSimulatedTheTruthIsFollowed) {
  Two two;
  const auto mix = two.mix({"psd"});
  const Pose start = mix->world()->robot_pose(0).value();
  ASSERT_TRUE(mix->world()->set_robot_pose(0, {start.x - 0.25, start.y, start.theta}));
  EXPECT_NEAR(mix->range_sensor(1)->read().value(), 0.75, 1e-9);
  ASSERT_TRUE(mix->drive()->set_odometry({7.0, -3.0, 1.5}));
  EXPECT_NEAR(mix->range_sensor(1)->read().value(), 0.75, 1e-9);
}

TEST(Mix, ACameraLooksFromWhereTheDriveIs) {
  Two two;
  const auto mix = two.mix_with_board({"camera"});
  const double start = mix->camera_view()->eye().x;
  ASSERT_TRUE(mix->drive()->start({0.2, 0.0, 0.2}));
  wait(*mix, 5.0);
  EXPECT_NEAR(mix->camera_view()->eye().x - start, 0.2, 0.01);
}

TEST(Mix, ThePartsClockKeepsUpWithTheProgramsTime) {
  Two two;
  const auto mix = two.mix({"compass"});
  wait(*mix, 3.0);
  ASSERT_TRUE(mix->compass()->read());
  EXPECT_EQ(two.other_backend->clock().now(), mix->clock().now());
}

TEST(Mix, StopsAllMotorsOfAll) {
  Two two;
  const auto mix = two.mix({"drive"});
  ASSERT_TRUE(mix->drive()->set_speed({0.2, 0.0}));
  wait(*mix, 1.0);
  mix->stop();
  wait(*mix, 1.0);
  ASSERT_TRUE(mix->drive()->status());
  const double stopped = two.other_backend->drive()->odometry().value().x;
  wait(*mix, 1.0);
  EXPECT_NEAR(mix->drive()->odometry().value().x, stopped, 1e-3);
}

/// A robot that cannot be told to stop.
class Unstoppable final : public PassingBackend {
 public:
  using PassingBackend::PassingBackend;
  Result<void> stop() noexcept override { return fail(Errc::Disconnected, "it is gone"); }
};

TEST(Mix, TellsThatAPartCouldNotBeStoppedAndStopsTheOthers) {
  Two two;
  ASSERT_TRUE(two.mix({"drive"})->stop());
  Two again;
  again.main.backend = std::make_unique<Unstoppable>(std::move(again.main.backend));
  const auto mix = again.mix({"drive"});
  ASSERT_TRUE(mix->drive()->set_speed({0.2, 0.0}));
  wait(*mix, 1.0);
  const auto done = mix->stop();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what, "it is gone");
  wait(*mix, 1.0);
  const double stopped = mix->drive()->odometry().value().x;
  wait(*mix, 1.0);
  EXPECT_NEAR(mix->drive()->odometry().value().x, stopped, 1e-3);
}

/// What make_mix() says.
std::string complaint(std::unique_ptr<Backend> part, const std::string& device) {
  std::vector<MixPart> parts;
  parts.push_back({{device}, "part", std::move(part)});
  try {
    make_mix(lockstep_rig(facing(1.0)).backend, std::move(parts));
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(Mix, ADeviceThatThePartLacksIsOneClearError) {
  const std::vector<ListedDevice> only_psd = {{"psd", 3, {9.999}}};
  EXPECT_EQ(complaint(make_absent_robot(only_psd), "psd"), "");
  for (const char* device : {"drive", "proximity", "bumper", "lidar", "compass", "gyroscope",
                             "accelerometer", "motor", "encoder", "servo", "camera"}) {
    EXPECT_EQ(complaint(make_absent_robot(only_psd), device),
              std::string(device) + "=part: that robot has no " + device);
  }
}

TEST(Mix, ARobotThatIsOnlyPutSomewhereFeelsNoMotion) {
  for (const char* device : {"gyroscope", "accelerometer"}) {
    EXPECT_THAT(complaint(lockstep_rig(facing(1.0)).backend, device),
                HasSubstr(std::string(device) +
                          "=part: that robot is put where the one that drives is, and feels no "
                          "motion of its own"));
  }
  Two whole;
  EXPECT_NE(whole.mix({"psd"})->gyroscope(), nullptr) << "the first one drives";
  Two wheels_elsewhere;
  const auto mix = wheels_elsewhere.mix({"drive", "motor", "encoder"});
  EXPECT_EQ(mix->gyroscope(), nullptr);
  EXPECT_EQ(mix->accelerometer(), nullptr);
  Two all;
  const auto driven = all.mix({"drive", "motor", "encoder", "gyroscope"});
  ASSERT_TRUE(driven->drive()->set_speed({0.0, 1.0}));
  wait(*driven, 2.0);
  EXPECT_NEAR(driven->gyroscope()->read().value(), 1.0, 0.01);
}

TEST(Mix, ARealTimePartInVirtualTimeIsOneClearError) {
  Rig part = sim_rig(facing(1.0), {{"factor", "50"}});
  EXPECT_THAT(complaint(std::move(part.backend), "psd"),
              HasSubstr("part lives in real time and the robot in virtual time"));
}

struct Wrong {
  const char* text;
  const char* message;
};

TEST(MixText, IsAListOfKindsAndBackends) {
  EXPECT_THAT(parse_mix(" psd = sim ;drive=serial:/dev/a?b=c;", {}),
              ElementsAre(MixEntry{"psd", "sim"}, MixEntry{"drive", "serial:/dev/a?b=c"}));
  EXPECT_THAT(parse_mix("", {}), IsEmpty());
}

TEST(MixText, SaysWhereAndWhatIsWrong) {
  const Wrong all[] = {
      {"psd=sim; wings=sim",
       "1:10: found 'wings' as a device, expected one of drive, motor, encoder"},
      {"psd", "found no backend for 'psd', expected one as in psd=sim"},
      {"psd=", "found no backend for 'psd'"},
      {"=sim", "found '' as a device"},
      {"psd=sim; psd=sim", "1:10: found 'psd' twice"},
      {"psd=:", "1:1: "},
  };
  for (const Wrong& wrong : all) {
    try {
      parse_mix(wrong.text, {"--mix"});
      ADD_FAILURE() << wrong.text;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr(wrong.message)) << wrong.text;
    }
  }
}

/// What opening the backend of `flags` says.
std::string complaint_about(const std::map<std::string, std::string>& flags) {
  NullLog log;
  try {
    const Config config = rig_config(flags);
    open_backend({config, log});
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(MixSetting, OpensTheBackendsThatItNames) {
  NullLog log;
  const Config config = rig_config({{"hal", "sim"}, {"mix", "psd=sim"}, {"fast", "true"}});
  const auto backend = open_backend({config, log});
  EXPECT_TRUE(backend->range_sensor(1)->read()) << "the same backend twice is one";
}

TEST(MixSetting, NamesWhatIsWrongWithABackend) {
  EXPECT_THAT(complaint_about({{"mix", "psd=moon"}}), HasSubstr("--mix"));
  EXPECT_THAT(complaint_about({{"mix", "psd=moon"}}), HasSubstr("unknown backend 'moon'"));
  EXPECT_THAT(complaint_about({{"mix", "psd=sim:room"}}), HasSubstr("--mix"));
  EXPECT_THAT(complaint_about({{"mix", "psd=serial:/dev/none"}}),
              HasSubstr("/dev/none: no such device"));
  EXPECT_THAT(complaint_about({{"mix", "wings=sim"}}), HasSubstr("found 'wings' as a device"));
}

TEST(MixSetting, KnowsWhetherOpeningHasEffects) {
  EXPECT_FALSE(opening_has_effects(rig_config({{"mix", "psd=sim"}})));
  EXPECT_TRUE(opening_has_effects(rig_config({{"mix", "psd=serial:/dev/none"}})));
  EXPECT_TRUE(opening_has_effects(rig_config({{"hal", "tcp:a:1"}, {"mix", "psd=sim"}})));
}

}  // namespace
}  // namespace eyebridge::hal
