#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "checks.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::python {

/// What add_object() is told of an object, beside its kind and place.
struct ObjectTraits {
  std::optional<std::pair<double, double>> size;  ///< Of a box: length and width, metres.
  std::optional<std::vector<std::pair<double, double>>> corners;  ///< Of a polygon, metres.
  std::optional<double> mass;                                     ///< Kilograms.
  std::optional<double> friction;
  std::optional<double> restitution;
  bool fixed = false;
  std::string lines;  ///< What more a `.sim` file can say of it.
};

/// The object that add_object() describes. Throws std::invalid_argument for a kind that there is
/// not, a box without a size and a polygon without corners, ConfigError for wrong lines and
/// corners.
inline world::ObjectSpec object_of(const std::string& kind, const Pose& pose,
                                   const ObjectTraits& traits) {
  constexpr std::array<std::string_view, 6> kKinds = {"golf",  "soccer", "can",
                                                      "crate", "box",    "polygon"};
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
  if ((kind == "polygon") != (traits.corners && !traits.corners->empty())) {
    refuse("corners", traits.corners ? "some" : "none",
           kind == "polygon" ? "x, y of three or more, metres" : "none: only a polygon has some");
  }
  std::string text = kind + " 0 0 0";
  if (traits.size) {
    text += fmt::format(" {} {}", m_to_mm(traits.size->first), m_to_mm(traits.size->second));
  }
  if (traits.corners) {
    for (const auto& [x, y] : *traits.corners)
      text += fmt::format(" {} {}", m_to_mm(x), m_to_mm(y));
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

/// Gives Python's `type` its add_object(), which describes what `add(self, object)` puts there.
template <class Class, class Add>
void define_add_object(Class& type, Add add) {
  namespace py = pybind11;
  using Self = typename Class::type;
  type.def(
      "add_object",
      [add](Self& self, const std::string& kind, double x, double y, double theta,
            std::optional<std::pair<double, double>> size,
            std::optional<std::vector<std::pair<double, double>>> corners,
            std::optional<double> mass, std::optional<double> friction,
            std::optional<double> restitution, bool fixed, std::string lines) {
        return add(self, object_of(kind, {x, y, theta},
                                   {size, std::move(corners), mass, friction, restitution, fixed,
                                    std::move(lines)}));
      },
      py::arg("kind"), py::arg("x"), py::arg("y"), py::arg("theta") = 0.0, py::kw_only(),
      py::arg("size") = py::none(), py::arg("corners") = py::none(), py::arg("mass") = py::none(),
      py::arg("friction") = py::none(), py::arg("restitution") = py::none(),
      py::arg("fixed") = false, py::arg("lines") = "");
}

}  // namespace eyebridge::python
