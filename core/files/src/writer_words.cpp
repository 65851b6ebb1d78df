#include "writer_words.hpp"

#include <algorithm>

#include "eyebridge/files/foreign_worlds.hpp"

namespace eyebridge::files {

WallBox box_of(const world::Wall& wall) {
  const Vec2 along = wall.b - wall.a;
  const Vec2 middle = 0.5 * (wall.a + wall.b);
  return {{middle.x, middle.y, arc_tan2(along.y, along.x)},
          norm(along),
          wall.thickness > 0 ? wall.thickness : kBareThickness};
}

std::string xml_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < ' ' ? '?' : c;
    }
  }
  return out;
}

std::vector<Pose> places_of_robots(const Scenario& scenario) {
  std::vector<Pose> places;
  for (const RobotPlacement& robot : scenario.robots) places.push_back(robot.pose);
  for (const world::StartPose& start : scenario.world.starts) {
    const auto is_there = [&](const Pose& pose) {
      return pose.position() == start.pose.position();
    };
    if (std::ranges::none_of(places, is_there)) places.push_back(start.pose);
  }
  return places;
}

void add_loss(std::vector<std::string>& losses, std::size_t count, std::string_view what,
              std::string_view rest) {
  if (count == 0) return;
  std::string loss = std::to_string(count) + ' ' + std::string(what) + (count == 1 ? "" : "s");
  if (!rest.empty()) loss += ' ' + std::string(rest);
  losses.push_back(std::move(loss));
}

std::vector<std::string> common_losses(const Scenario& scenario, BareWalls bare) {
  const world::WorldModel& world = scenario.world;
  std::vector<std::string> losses;
  if (world.floor_texture) losses.emplace_back("the texture of the floor");
  if (world.water) losses.emplace_back("the water");
  add_loss(losses, world.markers.size(), "marker");
  if (world.maze) add_loss(losses, world.maze->goals.size(), "goal", "of the maze");
  add_loss(losses, scenario.robots.size(), "robot", "(where they stand is a start)");
  add_loss(losses, scenario.newcomers.size(), "robot", "to come");
  if (bare == BareWalls::BecomeThin) {
    const auto is_bare = [](const world::Wall& wall) { return wall.thickness == 0; };
    add_loss(losses, static_cast<std::size_t>(std::ranges::count_if(world.walls, is_bare)),
             "bare wall", "(1 mm thick now)");
  }
  return losses;
}

std::vector<std::string> losses_of_map(const Scenario& scenario) {
  const world::WorldModel& world = scenario.world;
  std::vector<std::string> losses = common_losses(scenario, BareWalls::Stay);
  add_loss(losses, world.objects.size(), "object");
  add_loss(losses, world.starts.size(), "start");
  const auto is_special = [](const world::Wall& wall) {
    return wall.height != world::Wall::kDefaultHeight || wall.colour != world::Wall::kDefaultColour;
  };
  add_loss(losses, static_cast<std::size_t>(std::ranges::count_if(world.walls, is_special)), "wall",
           "with a height or colour of its own");
  return losses;
}

}  // namespace eyebridge::files
