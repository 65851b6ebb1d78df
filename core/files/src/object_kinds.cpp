#include "object_kinds.hpp"

#include "text.hpp"

namespace eyebridge::files {

std::optional<world::ObjectSpec> builtin_object(std::string_view name) {
  using world::ObjectKind;
  const std::string key = lower(name);
  world::ObjectSpec spec;
  spec.name = key;
  const auto as = [&](ObjectKind kind, double radius, double height, Rgb colour) {
    spec.kind = kind;
    spec.radius = radius;
    spec.height = height;
    spec.colour = colour;
    return spec;
  };
  // EyeSim does not publish its sizes. Golf: the rules' 42.67 mm ball, orange as in small-size
  // soccer. Soccer: a 110 mm toy ball. Can: a 330 ml drinks can. Crate: a disc that a 360 mm
  // maze cell still lets through.
  if (key == "golf") return as(ObjectKind::Ball, 0.0213, 0.0426, {255, 140, 0});
  if (key == "soccer") return as(ObjectKind::Ball, 0.055, 0.11, {255, 140, 0});
  if (key == "can") return as(ObjectKind::Can, 0.033, 0.115, {200, 30, 30});
  if (key == "crate") return as(ObjectKind::Can, 0.15, 0.2, {150, 110, 60});
  return std::nullopt;
}

}  // namespace eyebridge::files
