#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "checks.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::python {

/// What add_object() is told of an object, beside its kind and place.
struct ObjectTraits {
  std::optional<std::pair<double, double>> size;  ///< Of a box: length and width, metres.
  std::optional<double> mass;                     ///< Kilograms.
  std::optional<double> friction;
  std::optional<double> restitution;
  bool fixed = false;
  std::string lines;  ///< What more a `.sim` file can say of it.
};

/// The object that add_object() describes. Throws std::invalid_argument for a kind that there is
/// not and a box without a size, ConfigError for wrong lines.
inline world::ObjectSpec object_of(const std::string& kind, const Pose& pose,
                                   const ObjectTraits& traits) {
  constexpr std::array<std::string_view, 5> kKinds = {"golf", "soccer", "can", "crate", "box"};
  if (std::ranges::find(kKinds, kind) == kKinds.end()) {
    refuse("kind", kind, fmt::format("one of: {}", fmt::join(kKinds, ", ")));
  }
  need_finite("x", pose.x);
  need_finite("y", pose.y);
  need_finite("theta", pose.theta);
  if ((kind == "box") != traits.size.has_value()) {
    refuse("size", traits.size ? "a size" : "none",
           kind == "box" ? "length and width of the box, metres" : "none: only a box has one");
  }
  std::string text = kind + " 0 0 0";
  if (traits.size) {
    text += fmt::format(" {} {}", m_to_mm(traits.size->first), m_to_mm(traits.size->second));
  }
  world::ObjectSpec object = files::read_object_text(text + '\n' + traits.lines, "add_object");
  object.pose = {pose.x, pose.y, wrap_angle(pose.theta)};
  if (traits.size) object.size = {traits.size->first, traits.size->second};
  if (traits.mass) object.matter.mass = *traits.mass;
  if (traits.friction) object.matter.friction = traits.friction;
  if (traits.restitution) object.matter.restitution = traits.restitution;
  object.matter.fixed = object.matter.fixed || traits.fixed;
  return object;
}

}  // namespace eyebridge::python
