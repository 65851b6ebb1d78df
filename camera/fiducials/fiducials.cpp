#include "eyebridge/camera/fiducials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::camera {
namespace {

/// How far in front of a face one stands to look whether it can be seen, metres.
constexpr double kClose = 0.002;

/// One long side of a wall.
struct Face {
  Vec2 from;    ///< Its left end as one faces it.
  Vec2 along;   ///< Unit vector to the right.
  Vec2 normal;  ///< Unit vector away from the wall.
  double length = 0.0;
};

/// A stretch of a face, metres from its left end.
struct Stretch {
  double begin = 0.0;
  double end = 0.0;
};

Face face_of(const world::Wall& wall, bool left_of_wall) {
  const Vec2 from = left_of_wall ? wall.b : wall.a;
  const Vec2 to = left_of_wall ? wall.a : wall.b;
  const double length = norm(to - from);
  const Vec2 along = (1.0 / length) * (to - from);
  const Vec2 normal{along.y, -along.x};
  return {from + 0.5 * wall.thickness * normal, along, normal, length};
}

/// The part of `face` that `wall` covers where it touches it, or comes as close as kClose.
Stretch covered_by(const world::Wall& wall, const Face& face) {
  const auto in_face = [&](Vec2 point) {
    const Vec2 from_left = point - face.from;
    return Vec2{dot(from_left, face.along), dot(from_left, face.normal)};
  };
  Vec2 a = in_face(wall.a);
  Vec2 b = in_face(wall.b);
  const double half = 0.5 * wall.thickness;
  // Its middle line is cut down to what lies in front of the face within its half thickness.
  const double low = kClose - half;
  const double high = kClose + half;
  if (a.y > b.y) std::swap(a, b);
  if (a.y > high || b.y < low) return {};
  if (b.y > a.y) {
    const auto at = [&](double y) {
      return a + std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0) * (b - a);
    };
    const Vec2 first = at(low);
    b = at(high);
    a = first;
  }
  return {std::min(a.x, b.x) - half, std::max(a.x, b.x) + half};
}

/// What is left of `face` between walls that touch it, left to right.
std::vector<Stretch> free_stretches(const Face& face, const std::vector<world::Wall>& walls,
                                    const world::Wall& own) {
  std::vector<Stretch> covered;
  for (const world::Wall& wall : walls) {
    if (&wall == &own) continue;
    const Stretch stretch = covered_by(wall, face);
    if (stretch.end >= stretch.begin && stretch.end > 0.0 && stretch.begin < face.length) {
      covered.push_back(stretch);
    }
  }
  std::sort(covered.begin(), covered.end(),
            [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
  std::vector<Stretch> free;
  double begin = 0.0;
  for (const Stretch& stretch : covered) {
    if (stretch.begin > begin) free.push_back({begin, stretch.begin});
    begin = std::max(begin, stretch.end);
  }
  if (face.length > begin) free.push_back({begin, face.length});
  return free;
}

constexpr auto kFamilyNames = std::to_array<std::pair<std::string_view, FiducialFamily>>({
    {"aruco", FiducialFamily::Aruco5x5},
    {"tag36h11", FiducialFamily::Tag36h11},
    {"tag25h9", FiducialFamily::Tag25h9},
    {"tag16h5", FiducialFamily::Tag16h5},
});

class Placer {
 public:
  Placer(const world::WorldModel& model, const FiducialLayout& layout)
      : model_(model), layout_(layout) {}

  std::vector<Fiducial> place() && {
    for (const world::Wall& wall : model_.walls) {
      for (const bool left : {true, false}) {
        const Face face = face_of(wall, left);
        for (const Stretch& stretch : free_stretches(face, model_.walls, wall)) {
          mark(wall, face, stretch);
        }
      }
    }
    return std::move(fiducials_);
  }

 private:
  void mark(const world::Wall& wall, const Face& face, const Stretch& stretch) {
    const double length = stretch.end - stretch.begin;
    const double z = layout_.height > 0.0 ? layout_.height : 0.5 * wall.height;
    const double outer = std::min(
        {with_margin(layout_.size, layout_.family), length, 2.0 * std::min(z, wall.height - z)});
    const double size = outer * layout_.size / with_margin(layout_.size, layout_.family);
    if (!(size >= kSmallestFiducial)) return;
    // Half a thousandth more than fits still fits: lengths are sums of rounded numbers.
    const double most = std::floor(length / outer + 0.0005);
    const double count = std::clamp(std::round(length / layout_.spacing), 1.0, most);
    for (double i = 0.0; i < count; ++i) {
      const Vec2 centre = face.from + (stretch.begin + (i + 0.5) * length / count) * face.along;
      if (!is_inside(centre + kClose * face.normal) || is_taken(centre, face.normal, outer))
        continue;
      if (fiducials_.size() >= static_cast<std::size_t>(count_of(layout_.family))) {
        throw ConfigError({}, "the world needs more than " +
                                  std::to_string(count_of(layout_.family)) +
                                  " fiducials, expected at most as many as there are different "
                                  "ones: a wider spacing needs fewer");
      }
      fiducials_.push_back({static_cast<int>(fiducials_.size()), centre, z,
                            arc_tan2(face.normal.y, face.normal.x), size, layout_.family});
    }
  }

  [[nodiscard]] bool is_inside(Vec2 point) const {
    const Vec2 near = model_.corner;
    const Vec2 far = model_.far_corner();
    return point.x > near.x && point.x < far.x && point.y > near.y && point.y < far.y;
  }

  /// Walls that were drawn twice, or over each other, have one face.
  [[nodiscard]] bool is_taken(Vec2 centre, Vec2 normal, double outer) const {
    return std::any_of(fiducials_.begin(), fiducials_.end(), [&](const Fiducial& other) {
      const double distance = 0.5 * (outer + with_margin(other));
      return norm(other.centre - centre) < 0.999 * distance &&
             dot(Heading::from_angle(other.facing).forward(), normal) > 0.99;
    });
  }

  const world::WorldModel& model_;
  const FiducialLayout& layout_;
  std::vector<Fiducial> fiducials_;
};

}  // namespace

std::optional<FiducialFamily> family_named(std::string_view name) {
  for (const auto& [known, family] : kFamilyNames) {
    if (known == name) return family;
  }
  return std::nullopt;
}

std::vector<Fiducial> place_fiducials(const world::WorldModel& model,
                                      const FiducialLayout& layout) {
  if (!(layout.size >= kSmallestFiducial && layout.size <= 1.0)) {
    throw ConfigError(
        {}, "fiducials of " + std::to_string(layout.size) + " m, expected 0.015 m to 1 m");
  }
  if (!(layout.spacing > 0.0) || !(layout.height >= 0.0)) {
    throw ConfigError({}, "fiducials every " + std::to_string(layout.spacing) +
                              " m at a height of " + std::to_string(layout.height) +
                              " m, expected more than 0 m and at "
                              "least 0 m");
  }
  return Placer(model, layout).place();
}

}  // namespace eyebridge::camera
