// From what the user writes to a backend, or to one clear message.
#include "eyebridge/hal/registry.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A world file of its own for each test, gone afterwards.
class Registry : public testing::Test {
 protected:
  ~Registry() override { std::filesystem::remove(file_); }

  /// Writes a world of `name`'s type; its path.
  std::string write(const std::string& name, const std::string& text) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::path(testing::TempDir()) / (std::string(info->name()) + '_' + name);
    std::ofstream(file_, std::ios::binary) << text;
    return file_.string();
  }
  std::unique_ptr<Backend> open(std::map<std::string, std::string> flags) {
    flags.emplace("fast", "true");
    const Config config = rig_config(flags);
    return open_backend({config, log_});
  }
  /// What open() throws; "" when it opens.
  std::string complaint(const std::map<std::string, std::string>& flags) {
    try {
      open(flags);
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  }

  std::filesystem::path file_;
  KeepingLog log_;
};

TEST_F(Registry, OpensAnEmptyRoomWhenNothingIsSaid) {
  const auto backend = open({});
  EXPECT_EQ(backend->world()->robot_count(), 1);
  // An S4 in the middle of 2 m x 2 m: its front sensor sits 60 mm ahead of its centre,
  // and half of a wall stands in the room.
  EXPECT_NEAR(backend->range_sensor(1)->read().value(), 1.0 - 0.005 - 0.06, 1e-9);
  EXPECT_TRUE(backend->clock().is_virtual());
  EXPECT_NE(backend->camera_view(), nullptr);
}

TEST_F(Registry, OpensTheWorldThatTheConfigurationNames) {
  const std::string world = write("room.wld",
                                  "floor 4000 2000\n"
                                  "0 0 4000 0\n4000 0 4000 2000\n4000 2000 0 2000\n0 2000 0 0\n"
                                  "position 1000 1000 0\n"
                                  "2560 0 2560 2000 0 200\n");
  const auto backend = open({{"world", world}});
  EXPECT_NEAR(backend->range_sensor(1)->read().value(), 1.5, 1e-9);
}

TEST_F(Registry, StartsTheRobotThatTheConfigurationNames) {
  const auto s4 = open({{"robot", "s4"}});
  const auto other = open({{"robot", "LabBot"}});
  EXPECT_NE(s4->range_sensor(1)->read().value(), other->range_sensor(1)->read().value());
}

TEST_F(Registry, RunsInRealTimeUnlessToldOtherwise) {
  const Config config = Config::load({});
  EXPECT_FALSE(open_backend({config, log_})->clock().is_virtual());
}

TEST_F(Registry, NamesTheKnownBackendsForAnUnknownOne) {
  EXPECT_EQ(complaint({{"hal", "smi"}}),
            "--hal: unknown backend 'smi', expected one of: sim, serial, tcp, can, replay, remote");
  EXPECT_THAT(complaint({{"hal", "usb:/dev/ttyACM0"}}), HasSubstr("unknown backend 'usb'"));
}

TEST_F(Registry, RefusesABadUrl) {
  EXPECT_THAT(complaint({{"hal", ":"}}), HasSubstr("--hal: found ':', expected a URL"));
  EXPECT_THAT(complaint({{"hal", "sim:maze.maz"}}),
              HasSubstr("--hal: found 'sim:maze.maz', expected sim alone"));
  EXPECT_THAT(complaint({{"hal", "sim?fast=1"}}), HasSubstr("expected sim alone"));
}

TEST_F(Registry, RefusesAnUnknownRobot) {
  EXPECT_THAT(complaint({{"robot", "R2D2"}}), HasSubstr("--robot: no robot 'R2D2'"));
  const std::string world = write("room.wld", "floor 2000 2000\n");
  EXPECT_THAT(complaint({{"robot", "R2D2"}, {"world", world}}), HasSubstr("--robot: "));
}

TEST_F(Registry, RefusesAWorldThatIsMissingOrWrong) {
  EXPECT_THAT(complaint({{"world", "no/such.maz"}}), HasSubstr("no/such.maz"));
  const std::string world = write("bad.wld", "floor 2000 2000\nwal 1 2 3 4\n");
  EXPECT_THAT(complaint({{"world", world}, {"strict", "true"}}), HasSubstr(world + ":2:1: "));
}

TEST_F(Registry, ListsItsBackendsWithASummary) {
  ASSERT_THAT(backend_table(), testing::Not(IsEmpty()));
  for (const BackendFactory& row : backend_table()) {
    EXPECT_FALSE(row.summary.empty()) << row.scheme;
    EXPECT_NE(row.open, nullptr) << row.scheme;
  }
}

}  // namespace
}  // namespace eyebridge::hal
