// How deep the water is: lines of worlds and simulations, and who dives in it.

#include <gmock/gmock.h>

#include "reading.hpp"

namespace eyebridge::files {
namespace {

TEST(Water, IsAsDeepAsTheWorldSays) {
  const auto world_of = [](const std::string& text) {
    std::vector<Warning> warnings;
    return read_world(text, "w.wld", warnings);
  };
  const auto world_error = [&](const std::string& text) {
    return error_of([&] { world_of(text); });
  };
  EXPECT_EQ(world_of("floor 9 9\nwater 3500").water, 3.5);
  EXPECT_FALSE(world_of("floor 9 9").water);
  EXPECT_EQ(world_of("floor 9 9").water_depth(), 2.0);
  EXPECT_EQ(world_error("floor 9 9\n water 0"),
            "w.wld:2:8: the depth of the water is 0: expected 1 to 1000000");
  EXPECT_EQ(world_error("floor 9 9\nwater"),
            "w.wld:2:6: 'water' with 0 arguments: expected 'water MM'");
  EXPECT_EQ(world_error("floor 9 9\nwater 5\nwater 5"),
            "w.wld:3:1: a second 'water': expected one");
  EXPECT_EQ(world_error("floor 9 9\nwatr 5"),
            "w.wld:2:1: unknown keyword 'watr': expected 'water'?");
}

TEST(Water, IsAsDeepAsASimulationSays) {
  const auto sim_of = [](const std::string& text) {
    std::vector<Warning> warnings;
    return read_sim(text, "s.sim", warnings);
  };
  const auto error = [&](const std::string& text) { return error_of([&] { sim_of(text); }); };
  EXPECT_EQ(sim_of("world a.wld\nwater 800\n").water, 0.8);
  EXPECT_FALSE(sim_of("world a.wld\n").water);
  EXPECT_EQ(error("S4 1 2 0\nwater deep"),
            "s.sim:2:7: 'deep' found: expected the depth of the water, a number");
  EXPECT_EQ(error("water 1\nwater 1"), "s.sim:2:1: a second 'water': expected one");
}

TEST(Water, SubmarinesNeedItDeepEnough) {
  const auto load_error = [](const std::filesystem::path& path) {
    return error_of([&] { load_scenario(path); });
  };
  const Folder folder;
  const std::string pool = "floor 6000 6000\nwater 3000\n";
  const auto deep = load_scenario(folder.write("a.wld", pool), {.robot = "Mako"});
  EXPECT_EQ(deep.world.water, 3.0);
  EXPECT_EQ(deep.models.at(0).height, 0.46);
  EXPECT_EQ(deep.models.at(0).range_sensors.at(5).kind, robot::RangeKind::Down);
  const auto other = load_scenario(
      folder.write("b.sim", "world a.wld\nwater 500\nUSAL 2000 2000 0\nMako 4000 2000 0\n"));
  EXPECT_EQ(other.world.water, 0.5) << "the simulation's overrides it";
  EXPECT_THAT(load_error(folder.write("c.sim", "world a.wld\nwater 300\nMako 4000 2000 0\n")),
              testing::HasSubstr(
                  "c.sim:3:1: Mako is 460 mm high, in water of 300 mm: expected deeper water "
                  "('water MM')"));
  // One that is left out takes no place.
  const auto tolerant = load_scenario(
      folder.write("d.sim", "world a.wld\nwater 300\nMako 2000 2000 0\nS4 2100 2000 0\n"),
      {.reading = Reading::Tolerant});
  ASSERT_EQ(tolerant.robots.size(), 1u);
  EXPECT_EQ(tolerant.robots[0].pose.x, 2.1);
}

}  // namespace
}  // namespace eyebridge::files
