#include <algorithm>
#include <array>
#include <cmath>

#include "eyebridge/files/readers.hpp"
#include "object_lines.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr std::array<std::string_view, 8> kObjectKeywords = {
    "obj", "name", "scale", "collider", "capsule", "sphere", "box", "buoyancy"};
constexpr double kMaxValue = 1e9;  // model units, before `scale`

struct Extent {
  double reach = 0;  ///< From the centre, seen from above, before scaling.
  double top = 0;
  bool sphere = true;  ///< Spheres only.
  bool metres = false;
  int shapes = 0;
  Vec2 box;  ///< Length along z, which is ahead, and width of the last box about the centre.
};

/// The shape whose numbers start at token `first`: the centre, then the size (EyeSim's order).
void add_shape(const Statement& s, const std::string& shape, std::size_t first, Extent& extent) {
  const auto value = [&](std::size_t i) {
    return std::abs(s.number(first + i, "a number of the shape", -kMaxValue, kMaxValue));
  };
  const double x = value(0);
  const double y = value(1);
  const double z = value(2);
  ++extent.shapes;
  const double centre = std::sqrt(x * x + z * z);
  if (shape == "sphere") {
    s.expect_arguments(first + 3, "sphere cx cy cz r");
    extent.reach = std::max(extent.reach, centre + value(3));
    extent.top = std::max(extent.top, y + value(3));
    return;
  }
  extent.sphere = false;
  if (shape == "box") {
    s.expect_arguments(first + 5, "box cx cy cz sx sy sz");
    extent.reach = std::max(extent.reach, centre + std::max(value(3), value(5)) / 2);
    extent.top = std::max(extent.top, y + value(4) / 2);
    if (centre == 0) extent.box = {value(5), value(3)};
    return;
  }
  s.expect_arguments(first + 5, "capsule cx cy cz r h x|y|z");
  const std::string axis = lower(s.text(first + 5));
  if (axis != "x" && axis != "y" && axis != "z") s.fail(first + 5, "expected x, y or z");
  const double radius = value(3);
  const double half = std::max(value(4) / 2, radius);
  extent.reach = std::max(extent.reach, centre + (axis == "y" ? radius : half));
  extent.top = std::max(extent.top, y + (axis == "y" ? half : radius));
}

}  // namespace

world::ObjectSpec read_object(std::string_view text, const std::string& file,
                              const std::string& name, std::vector<Warning>& out_warnings,
                              Reading reading) {
  StatementReader statements(text, file);
  Warnings warnings(file, out_warnings);
  Extent extent;
  double scale = 1;
  world::ObjectSpec out;
  out.name = lower(name);
  read_lines(statements, warnings, reading, [&](const Statement& s) {
    const std::string keyword = lower(s.text(0));
    if (keyword == "scale") {
      s.expect_arguments(1, "scale FACTOR");
      scale = s.number(1, "the scale", 1e-9, 1e9);
    } else if (keyword == "name") {
      if (s.size() < 2) s.fail(1, "line ends: expected the object's name");
      out.name = lower(s.rest(1));
    } else if (keyword == "collider") {
      if (s.size() < 2) s.fail(1, "line ends: expected box, sphere or capsule");
      const std::string shape = lower(s.text(1));
      if (shape != "box" && shape != "sphere" && shape != "capsule") {
        s.fail(1, in_quotes(s.text(1)) + " found: expected box, sphere or capsule");
      }
      add_shape(s, shape, 2, extent);
    } else if (keyword == "box" || keyword == "sphere" || keyword == "capsule") {
      extent.metres = true;  // the form without `collider` counts in metres
      add_shape(s, keyword, 1, extent);
    } else if (keyword == "mass" && s.size() > 2) {  // EyeSim's form has the centre of mass, too
      s.expect_arguments(4, "mass KG x y z");
      const double mass = s.number(1, "the mass in kilograms", 0, 1e6);
      if (mass > 0) {
        out.matter.mass = mass;
      } else {
        warnings.add(s.line(), s.token(1).column, "mass 0 is ignored: expected more");
      }
    } else if (is_object_trait(keyword) && keyword != "path") {  // which is of a place
      read_more(s, out);
    } else if (std::find(kObjectKeywords.begin(), kObjectKeywords.end(), keyword) ==
               kObjectKeywords.end()) {
      warnings.add(s.line(), s.token(0).column,
                   "unknown keyword " + in_quotes(s.text(0)) + " is ignored");
    }
  });
  const double unit = extent.metres ? scale : scale / 1000;
  out.radius = extent.reach * unit;
  out.height = std::max(extent.top * unit, 0.001);
  if (!(out.radius >= 0.001 && out.radius <= 10 && out.height <= 100)) {
    throw ConfigError({file, std::max(1, statements.line()), 1},
                      "object without a usable size: expected 'collider box|sphere|capsule' of 1 "
                      "mm to 10 m");
  }
  out.kind = extent.sphere ? world::ObjectKind::Ball : world::ObjectKind::Can;
  if (extent.shapes == 1 && unit * std::min(extent.box.x, extent.box.y) >= 0.001) {
    out.kind = world::ObjectKind::Box;
    out.size = unit * extent.box;
    out.radius = out.outer_radius();
  }
  out.colour = {160, 160, 160};
  return out;
}

}  // namespace eyebridge::files
