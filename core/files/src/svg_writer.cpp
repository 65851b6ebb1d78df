#include <algorithm>

#include <fmt/format.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/foreign_worlds.hpp"
#include "text.hpp"
#include "writer_words.hpp"

namespace eyebridge::files {
namespace {

constexpr double kStartRadius = 50;  // millimetres

std::string colour_of(const world::Wall& wall) {
  if (wall.colour == world::Wall::kDefaultColour) return "black";
  const Rgb c = wall.colour;
  if (c == Rgb{}) return "#010101";  // black stands for no colour of its own
  return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

}  // namespace

WrittenWorld write_svg(const Scenario& scenario, const std::string& name) {
  const world::WorldModel& world = scenario.world;
  WrittenWorld out;
  out.losses = common_losses(scenario, BareWalls::BecomeThin);
  add_loss(out.losses, world.objects.size(), "object");
  const auto has_own_height = [](const world::Wall& wall) {
    return wall.height != world::Wall::kDefaultHeight;
  };
  add_loss(out.losses, static_cast<std::size_t>(std::ranges::count_if(world.walls, has_own_height)),
           "height", "of walls");
  const Vec2 far = world.far_corner();
  const auto mm = [](double metres) { return fmt::format("{:.9g}", m_to_mm(metres)); };
  const auto x = [&](double metres) { return mm(metres - world.corner.x); };
  const auto y = [&](double metres) { return mm(far.y - metres); };
  out.text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 "
      "{0} {1}\"{2}>\n<title>{3}</title>\n<g fill=\"none\">\n",
      mm(world.width), mm(world.height),
      world.corner == Vec2{}
          ? ""
          : fmt::format(" data-corner=\"{} {}\"", mm(world.corner.x), mm(world.corner.y)),
      xml_text(name));
  for (const world::Wall& wall : world.walls) {
    const double width = wall.thickness > 0 ? wall.thickness : kBareThickness;
    out.text += fmt::format(
        "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n",
        x(wall.a.x), y(wall.a.y), x(wall.b.x), y(wall.b.y), colour_of(wall), mm(width));
  }
  out.text += "</g>\n";
  for (const Pose& pose : places_of_robots(scenario)) {
    out.text += fmt::format(
        "<circle class=\"start\" cx=\"{}\" cy=\"{}\" r=\"{}\" data-heading=\"{}\" "
        "fill=\"green\"/>\n",
        x(pose.x), y(pose.y), kStartRadius, decimal(rad_to_deg(pose.theta)));
  }
  out.text += "</svg>\n";
  return out;
}

}  // namespace eyebridge::files
