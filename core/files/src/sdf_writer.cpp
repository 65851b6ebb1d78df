#include <string>

#include <fmt/format.h>

#include "eyebridge/files/foreign_worlds.hpp"
#include "text.hpp"
#include "writer_words.hpp"

namespace eyebridge::files {
namespace {

/// "x y z roll pitch yaw": metres, radians.
std::string pose_text(const Pose& pose, double z) {
  return fmt::format("<pose>{} {} {} 0 0 {}</pose>", decimal(pose.x), decimal(pose.y), decimal(z),
                     decimal(pose.theta));
}

std::string material_of(Rgb colour) {
  const std::string rgb =
      fmt::format("{:.3f} {:.3f} {:.3f} 1", colour.r / 255.0, colour.g / 255.0, colour.b / 255.0);
  return fmt::format("<material><ambient>{0}</ambient><diffuse>{0}</diffuse></material>", rgb);
}

std::string box_text(double length, double width, double height) {
  return fmt::format("<geometry><box><size>{} {} {}</size></box></geometry>", decimal(length),
                     decimal(width), decimal(height));
}

/// What is seen and what is touched are the same.
std::string shape_text(const std::string& name, const std::string& pose,
                       const std::string& geometry, Rgb colour, const std::string& surface = {}) {
  return fmt::format(
      "      <collision name=\"{0}\">{1}{2}{3}</collision>\n"
      "      <visual name=\"{0}\">{1}{2}{4}</visual>\n",
      name, pose, geometry, surface, material_of(colour));
}

std::string walls_text(const world::WorldModel& world) {
  if (world.walls.empty()) return {};
  std::string out =
      "    <model name=\"walls\">\n      <static>true</static>\n      <link name=\"link\">\n";
  int number = 0;
  for (const world::Wall& wall : world.walls) {
    const WallBox box = box_of(wall);
    out += shape_text("wall_" + std::to_string(++number), pose_text(box.pose, wall.height / 2),
                      box_text(box.length, box.thickness, wall.height), wall.colour);
  }
  return out + "      </link>\n    </model>\n";
}

/// About the axes through its middle (of a polygon: of the disc that covers it).
std::string inertia_of(const world::ObjectSpec& object) {
  const double m = object.matter.mass;
  double xx = 0;
  double yy = 0;
  double zz = 0;
  if (object.kind == world::ObjectKind::Ball) {
    xx = yy = zz = 0.4 * m * object.radius * object.radius;
  } else if (object.kind == world::ObjectKind::Box) {
    const double a = object.size.x * object.size.x;
    const double b = object.size.y * object.size.y;
    const double c = object.height * object.height;
    xx = m * (b + c) / 12;
    yy = m * (a + c) / 12;
    zz = m * (a + b) / 12;
  } else {
    const double r = object.outer_radius();
    xx = yy = m * (3 * r * r + object.height * object.height) / 12;
    zz = m * r * r / 2;
  }
  return fmt::format(
      "        <inertial><mass>{}</mass><inertia><ixx>{:g}</ixx><iyy>{:g}</iyy><izz>{:g}</izz>"
      "<ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial>\n",
      decimal(m), xx, yy, zz);
}

std::string geometry_of(const world::ObjectSpec& object) {
  switch (object.kind) {
    case world::ObjectKind::Ball:
      return fmt::format("<geometry><sphere><radius>{}</radius></sphere></geometry>",
                         decimal(object.radius));
    case world::ObjectKind::Can:
      return fmt::format(
          "<geometry><cylinder><radius>{}</radius><length>{}</length></cylinder></geometry>",
          decimal(object.radius), decimal(object.height));
    case world::ObjectKind::Box:
      return box_text(object.size.x, object.size.y, object.height);
    case world::ObjectKind::Polygon:
      break;
  }
  std::string points;
  for (const Vec2 p : object.corners) {
    points += fmt::format("<point>{} {}</point>", decimal(p.x), decimal(p.y));
  }
  return fmt::format("<geometry><polyline>{}<height>{}</height></polyline></geometry>", points,
                     decimal(object.height));
}

std::string surface_of(const world::Matter& matter) {
  std::string out;
  if (matter.restitution) {
    out += fmt::format("<bounce><restitution_coefficient>{}</restitution_coefficient></bounce>",
                       decimal(*matter.restitution));
  }
  if (matter.friction) {
    out += fmt::format("<friction><ode><mu>{0}</mu><mu2>{0}</mu2></ode></friction>",
                       decimal(*matter.friction));
  }
  return out.empty() ? out : "<surface>" + out + "</surface>";
}

std::string object_text(const world::ObjectSpec& object, int number) {
  // A polyline stands on its plane, all else lies about its middle.
  const double up = object.kind == world::ObjectKind::Ball      ? object.radius
                    : object.kind == world::ObjectKind::Polygon ? 0
                                                                : object.height / 2;
  return fmt::format(
      "    <model name=\"{} {}\">\n      <static>{}</static>\n      {}\n"
      "      <link name=\"link\">\n{}{}      </link>\n    </model>\n",
      xml_text(object.name), number, object.matter.fixed, pose_text(object.pose, up),
      inertia_of(object),
      shape_text("shape", "", geometry_of(object), object.colour, surface_of(object.matter)));
}

}  // namespace

WrittenWorld write_sdf(const Scenario& scenario, const std::string& name) {
  const world::WorldModel& world = scenario.world;
  WrittenWorld out;
  out.losses = common_losses(scenario, BareWalls::BecomeThin);
  for (const world::ObjectSpec& object : world.objects) {
    if (object.path || object.reaction) {
      out.losses.push_back("how the " + object.name + " moves by itself");
    }
  }
  out.text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<sdf version=\"1.9\">\n  <world name=\"{}\">\n"
      "    <light name=\"sun\" type=\"directional\"><direction>-0.5 0.1 -0.9</direction></light>\n"
      "    <model name=\"floor\">\n      <static>true</static>\n      {}\n      <link "
      "name=\"link\">\n{}      </link>\n    </model>\n",
      xml_text(name), pose_text({world.middle().x, world.middle().y, 0}, 0),
      shape_text("plane", "",
                 fmt::format("<geometry><plane><normal>0 0 1</normal><size>{} {}</size></plane>"
                             "</geometry>",
                             decimal(world.width), decimal(world.height)),
                 {200, 200, 200}));
  int number = 0;
  for (const Pose& pose : places_of_robots(scenario)) {
    out.text +=
        fmt::format("    <frame name=\"start_{}\">{}</frame>\n", ++number, pose_text(pose, 0));
  }
  out.text += walls_text(world);
  number = 0;
  for (const world::ObjectSpec& object : world.objects) out.text += object_text(object, ++number);
  out.text += "  </world>\n</sdf>\n";
  return out;
}

}  // namespace eyebridge::files
