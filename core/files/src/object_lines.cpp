#include "object_lines.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace eyebridge::files {
namespace {

constexpr std::array<std::string_view, 4> kTraits = {"mass", "friction", "restitution", "fixed"};
constexpr double kLeastSize = 1;  // millimetres
constexpr double kMostSize = 10000;

}  // namespace

bool is_object_trait(std::string_view keyword) {
  return std::find(kTraits.begin(), kTraits.end(), keyword) != kTraits.end();
}

void read_object_trait(const Statement& s, ObjectTraits& traits) {
  const std::string keyword = lower(s.text(0));
  if (!traits.any) traits.where = s.where(0);
  traits.any = true;
  if (keyword == "fixed") {
    s.expect_arguments(0, "fixed");
    traits.fixed = true;
  } else if (keyword == "mass") {
    s.expect_arguments(1, "mass KG");
    traits.mass = s.number(1, "the mass in kilograms", 0.001, 10000);
  } else if (keyword == "friction") {
    s.expect_arguments(1, "friction MU");
    traits.friction = s.number(1, "the coefficient of friction", 0, 100);
  } else {
    s.expect_arguments(1, "restitution E");
    traits.restitution = s.number(1, "the restitution", 0, 1);
  }
}

void apply(const ObjectTraits& traits, world::ObjectSpec& object) {
  world::Matter& matter = object.matter;
  if (traits.mass) matter.mass = *traits.mass;
  if (traits.friction) matter.friction = traits.friction;
  if (traits.restitution) matter.restitution = traits.restitution;
  if (traits.fixed) matter.fixed = true;
}

world::ObjectSpec read_box(const Statement& s, const Pose& pose) {
  world::ObjectSpec box;
  box.kind = world::ObjectKind::Box;
  box.name = "box";
  box.pose = pose;
  box.size = {s.millimetres(4, "the length", kLeastSize, kMostSize),
              s.millimetres(5, "the width", kLeastSize, kMostSize)};
  box.radius = box.outer_radius();
  box.height = s.size() > 6 ? s.millimetres(6, "the height", kLeastSize, kMostSize) : 0.2;
  box.matter.mass = 1.0;
  box.colour = {150, 110, 60};
  if (s.size() > 7) {
    const auto channel = [&](std::size_t i) {
      return static_cast<std::uint8_t>(s.integer(i, "a colour", 0, 255));
    };
    box.colour = {channel(7), channel(8), channel(9)};
  }
  return box;
}

}  // namespace eyebridge::files
