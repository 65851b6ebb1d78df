#include "object_lines.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "motion_lines.hpp"

namespace eyebridge::files {
namespace {

constexpr std::array<std::string_view, 5> kTraits = {"mass", "friction", "restitution", "fixed",
                                                     "path"};
constexpr double kLeastSize = 1;  // millimetres
constexpr double kMostSize = 10000;
constexpr std::size_t kMostPoints = 1000;

/// "path SPEED loop|back x1 y1 [x2 y2 ...]"
world::Path read_path(const Statement& s) {
  constexpr std::string_view kForm = "path MM_PER_SECOND loop|back x1 y1 [x2 y2 ...]";
  if (s.size() < 5 || s.size() % 2 == 0) s.expect_arguments(s.size() < 5 ? 4 : s.size(), kForm);
  if (s.size() > 3 + 2 * kMostPoints) s.fail(0, "more than 1000 way-points");
  world::Path path;
  path.speed = s.millimetres(1, "the speed", 0.1, 100000);
  const std::string kind = lower(s.text(2));
  if (kind != "loop" && kind != "back") {
    s.fail(2, in_quotes(s.text(2)) + " found: expected 'loop' or 'back'");
  }
  path.loop = kind == "loop";
  for (std::size_t i = 3; i < s.size(); i += 2) {
    const Vec2 point{s.millimetres(i, "x of a way-point"),
                     s.millimetres(i + 1, "y of a way-point")};
    if (!path.points.empty() && point == path.points.back()) {
      s.fail(i, "a way-point where the one before it is: expected another place");
    }
    path.points.push_back(point);
  }
  return path;
}

}  // namespace

bool is_object_trait(std::string_view keyword) {
  return std::find(kTraits.begin(), kTraits.end(), keyword) != kTraits.end() ||
         is_motion_trait(keyword);
}

void read_object_trait(const Statement& s, ObjectTraits& traits) {
  const std::string keyword = lower(s.text(0));
  if (!traits.any) traits.where = s.where(0);
  traits.any = true;
  if (keyword == "fixed") {
    s.expect_arguments(0, "fixed");
    traits.fixed = true;
  } else if (is_motion_trait(keyword)) {
    read_motion_trait(s, traits);
  } else if (keyword == "path") {
    if (traits.reaction) s.fail(0, "'path' for one that moves otherwise: expected one of them");
    traits.path = read_path(s);
    traits.path_where = s.where(0);
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
  // One takes the place of the other.
  if (traits.path) {
    object.path = traits.path;
    object.reaction.reset();
  } else if (traits.reaction) {
    object.reaction = traits.reaction;
    object.path.reset();
  }
  if (traits.yields_within) object.yields_within = *traits.yields_within;
}

world::ObjectSpec read_box(const Statement& s, const Pose& pose) {
  world::ObjectSpec box;
  box.kind = world::ObjectKind::Box;
  box.name = "box";
  box.pose = pose;
  box.size = {s.millimetres(4, "the length", kLeastSize, kMostSize),
              s.millimetres(5, "the width", kLeastSize, kMostSize)};
  box.radius = box.outer_radius();
  box.height = s.size() > 6 ? s.millimetres(6, "the height", kLeastSize, kMostSize) : kBoxHeight;
  box.matter.mass = kBoxMass;
  box.colour = kBoxColour;
  if (s.size() > 7) {
    const auto channel = [&](std::size_t i) {
      return static_cast<std::uint8_t>(s.integer(i, "a colour", 0, 255));
    };
    box.colour = {channel(7), channel(8), channel(9)};
  }
  return box;
}

}  // namespace eyebridge::files
