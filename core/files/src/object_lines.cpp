#include "object_lines.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "motion_lines.hpp"

namespace eyebridge::files {
namespace {

constexpr std::array<std::string_view, 7> kTraits = {"mass", "friction", "restitution", "fixed",
                                                     "path", "loose",    "still"};
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
    traits.loose = false;
  } else if (keyword == "loose") {
    s.expect_arguments(0, "loose");
    traits.fixed = false;
    traits.loose = true;
  } else if (keyword == "still") {
    s.expect_arguments(0, "still");
    traits.path.reset();
    traits.reaction.reset();
    traits.yields_within.reset();
    traits.still = true;
  } else if (is_motion_trait(keyword)) {
    read_motion_trait(s, traits);
  } else if (keyword == "path") {
    if (traits.reaction) s.fail(0, "'path' for one that moves otherwise: expected one of them");
    traits.path = read_path(s);
    traits.still = false;
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

ObjectTraits read_more(const Statement& s, world::ObjectSpec& object) {
  ObjectTraits traits;  // some lines say more of what others said
  traits.path = object.path;
  traits.reaction = object.reaction;
  read_object_trait(s, traits);
  apply(traits, object);
  return traits;
}

void apply(const ObjectTraits& traits, world::ObjectSpec& object) {
  world::Matter& matter = object.matter;
  if (traits.mass) matter.mass = *traits.mass;
  if (traits.friction) matter.friction = traits.friction;
  if (traits.restitution) matter.restitution = traits.restitution;
  if (traits.fixed || traits.loose) matter.fixed = traits.fixed;
  if (traits.still) {
    object.path.reset();
    object.reaction.reset();
    object.yields_within = 0.0;
  }
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

namespace {

Rgb read_colour(const Statement& s, std::size_t first) {
  const auto channel = [&](std::size_t i) {
    return static_cast<std::uint8_t>(s.integer(i, "a colour", 0, 255));
  };
  return {channel(first), channel(first + 1), channel(first + 2)};
}

/// What a box or polygon is, but for its outline.
world::ObjectSpec block(world::ObjectKind kind, const std::string& name, const Pose& pose) {
  world::ObjectSpec out;
  out.kind = kind;
  out.name = name;
  out.pose = pose;
  out.height = kBoxHeight;
  out.matter.mass = kBoxMass;
  out.colour = kBoxColour;
  return out;
}

/// Token of the first corner in "polygon x y phi x1 y1 ...".
constexpr std::size_t kFirstCorner = 4;

/// Counter-clockwise; fails at the corner that cannot be.
std::vector<Vec2> read_corners(const Statement& s, std::size_t end) {
  std::vector<Vec2> corners;
  if ((end - kFirstCorner) / 2 > world::kMostCorners) {
    s.fail(kFirstCorner + 2 * world::kMostCorners,
           "more than " + std::to_string(world::kMostCorners) + " corners of a polygon");
  }
  for (std::size_t i = kFirstCorner; i + 1 < end; i += 2) {
    corners.push_back({s.millimetres(i, "x of a corner", -kMostSize, kMostSize),
                       s.millimetres(i + 1, "y of a corner", -kMostSize, kMostSize)});
  }
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i] == corners[i - 1]) {
      s.fail(kFirstCorner + 2 * i, "a corner where the one before it is: expected another place");
    }
  }
  double turned = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    turned += cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  const bool clockwise = turned < 0.0;
  if (clockwise) std::ranges::reverse(corners);
  if (const auto fault = world::fault_of_corners(corners)) {
    const std::size_t last = corners.size() - 1;
    const bool is_one = fault->corner <= last;
    const std::size_t corner = clockwise && is_one ? last - fault->corner : fault->corner;
    s.fail(kFirstCorner + 2 * corner,
           "corner " + std::to_string(corner + 1) + " of the polygon: expected " + fault->expected);
  }
  return corners;
}

}  // namespace

world::ObjectSpec read_polygon(const Statement& s, const Pose& pose) {
  world::ObjectSpec polygon = block(world::ObjectKind::Polygon, "polygon", pose);
  std::size_t at = kFirstCorner;
  while (s.is_number(at)) ++at;
  if (at % 2 != 0) s.fail(at, "x of a corner without its y: expected x1 y1 x2 y2 x3 y3 ...");
  polygon.corners = read_corners(s, at);
  polygon.radius = polygon.outer_radius();
  for (; at < s.size();) {
    const std::string word = lower(s.text(at));
    if (word == "height") {
      polygon.height = s.millimetres(at + 1, "the height", kLeastSize, kMostSize);
      at += 2;
    } else if (word == "colour" || word == "color") {
      polygon.colour = read_colour(s, at + 1);
      at += 4;
    } else {
      s.fail(at,
             in_quotes(s.text(at)) + " found: expected a corner, 'height MM' or 'colour R G B'");
    }
  }
  return polygon;
}

world::ObjectSpec read_box(const Statement& s, const Pose& pose) {
  world::ObjectSpec box = block(world::ObjectKind::Box, "box", pose);
  box.size = {s.millimetres(4, "the length", kLeastSize, kMostSize),
              s.millimetres(5, "the width", kLeastSize, kMostSize)};
  box.radius = box.outer_radius();
  if (s.size() > 6) box.height = s.millimetres(6, "the height", kLeastSize, kMostSize);
  if (s.size() > 7) box.colour = read_colour(s, 7);
  return box;
}

world::ObjectSpec standing_box(const std::string& name) {
  world::ObjectSpec box = block(world::ObjectKind::Box, name, {});
  box.size = {kStandInSize, kStandInSize};
  box.radius = box.outer_radius();
  box.matter.fixed = true;
  return box;
}

}  // namespace eyebridge::files
