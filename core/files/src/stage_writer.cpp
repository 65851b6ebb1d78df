#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/foreign_worlds.hpp"
#include "text.hpp"
#include "writer_words.hpp"

namespace eyebridge::files {
namespace {

constexpr int kRoundCorners = 16;  // of what is round: Stage has polygons alone

std::string pose_text(const Pose& pose) {
  return fmt::format("pose [ {} {} 0 {} ]", decimal(pose.x), decimal(pose.y),
                     decimal(rad_to_deg(pose.theta)));
}

std::string colour_text(Rgb colour) {
  return fmt::format("color_rgba [ {:.3f} {:.3f} {:.3f} 1 ]", colour.r / 255.0, colour.g / 255.0,
                     colour.b / 255.0);
}

std::vector<Vec2> outline_of(const world::ObjectSpec& object) {
  std::vector<Vec2> outline = corners_of(object);
  if (!outline.empty()) return outline;
  for (int i = 0; i < kRoundCorners; ++i) {
    outline.push_back(object.radius * Heading::from_angle(2 * kPi * i / kRoundCorners).forward());
  }
  return outline;
}

/// Stage moves and stretches the outline of a model until it fits `size` about its pose.
std::string model_of(const world::ObjectSpec& object) {
  const std::vector<Vec2> outline = outline_of(object);
  Vec2 low = outline.front();
  Vec2 high = low;
  std::string points;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 p = outline[i];
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    points += fmt::format(" point[{}] [ {} {} ]", i, decimal(p.x), decimal(p.y));
  }
  const Vec2 middle = 0.5 * (low + high);
  const Vec2 place = object.pose.position() + Heading::from_angle(object.pose.theta).rotate(middle);
  return fmt::format("thing ( {} size [ {} {} {} ] {} block ( points {}{} z [ 0 1 ] ) )\n",
                     pose_text({place.x, place.y, object.pose.theta}), decimal(high.x - low.x),
                     decimal(high.y - low.y), decimal(object.height), colour_text(object.colour),
                     outline.size(), points);
}

}  // namespace

WrittenWorld write_stage(const Scenario& scenario, const std::string& name) {
  const world::WorldModel& world = scenario.world;
  WrittenWorld out;
  out.losses = common_losses(scenario, BareWalls::BecomeThin);
  add_loss(out.losses, world.objects.size(), "object", "that can be pushed (they stand still now)");
  const Vec2 middle = world.middle();
  constexpr double kPixels = 700;
  out.text = fmt::format(
      "# {}, written by EyeBridge: metres, degrees\n"
      "resolution 0.01\n"
      "interval_sim 50\n"
      "window ( size [ {} {} ] center [ {} {} ] scale {:.3f} )\n\n"
      "define wall model ( gui_nose 0 gui_grid 0 gui_move 0 )\n"
      "define thing model ( gui_nose 0 gui_grid 0 )\n"
      "define robot position ( size [ 0.15 0.15 0.1 ] drive \"diff\" color \"blue\" )\n\n",
      printable(name), kPixels, kPixels, decimal(middle.x), decimal(middle.y),
      0.9 * kPixels / std::max(world.width, world.height));
  for (const world::Wall& wall : world.walls) {
    const WallBox box = box_of(wall);
    out.text +=
        fmt::format("wall ( {} size [ {} {} {} ] {} )\n", pose_text(box.pose), decimal(box.length),
                    decimal(box.thickness), decimal(wall.height), colour_text(wall.colour));
  }
  for (const world::ObjectSpec& object : world.objects) out.text += model_of(object);
  int number = 0;
  for (const Pose& pose : places_of_robots(scenario)) {
    out.text += fmt::format("robot ( name \"robot{}\" {} )\n", ++number, pose_text(pose));
  }
  return out;
}

}  // namespace eyebridge::files
