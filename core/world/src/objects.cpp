#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "eyebridge/base/units.hpp"
#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

// Metres. As for robots: what fills its place is free there, whatever rounding made of it.
constexpr double kTouching = 1e-9;

// Metres from the origin: beyond, nothing that is added could ever be met.
constexpr double kFarthest = 1e6;

}  // namespace

std::optional<std::string> World::Impl::obstacle_of(const ObjectSpec& object, BodyId ignore) const {
  const Vec2 centre = object.pose.position();
  const double radius = object.outer_radius();
  std::optional<Convex> shape;  // of what is no disc
  if (shape_of(object.kind) == BodyShape::Polygon) {
    shape.emplace(Outline(corners_of(object)), centre,
                  Heading::from_angle(object.pose.theta).forward());
  }
  double to_walls = std::numeric_limits<double>::infinity();
  if (!shape) to_walls = walls.distance(centre, radius) - radius;
  walls.each_near(centre, radius, [&](std::uint32_t segment, double) {
    if (!shape) return;
    to_walls = std::min(to_walls, separation(*shape, Convex(walls.segments()[segment])).distance);
  });
  if (to_walls < -kTouching || walls.inside_thick(centre)) return "a wall";
  const auto gap_to = [&](BodyId other) {
    if (!shape) return gap_to_point(other, centre) - radius;
    if (bodies.is_convex(other)) return separation(*shape, bodies.convex(other)).distance;
    return distance_to(*shape, bodies.position(other)) - bodies.radius_[other];
  };
  BodyId met = kNoBody;
  bodies.each_on_way(centre, {}, radius, [&](BodyId other) {
    if (other != ignore && other < met && gap_to(other) < -kTouching) met = other;
  });
  if (met == kNoBody) return std::nullopt;
  const Vec2 place = bodies.position(met);
  return fmt::format("{} at ({:.3f}, {:.3f}) m",
                     bodies.shape_[met] == BodyShape::Robot ? "a robot" : "another object", place.x,
                     place.y);
}

const World::Impl::Thing* World::Impl::thing_of(BodyId id) const {
  const auto found = std::ranges::lower_bound(things, id, {}, &Thing::body);
  return found != things.end() && found->body == id ? &*found : nullptr;
}

BodyId World::add_object(const ObjectSpec& object) {
  const Pose& pose = object.pose;
  if (!(std::abs(pose.x) <= kFarthest && std::abs(pose.y) <= kFarthest) ||
      !std::isfinite(pose.theta)) {
    throw std::invalid_argument("object: expected a pose within 1000 km");
  }
  check_object(object);
  if (const auto obstacle = impl_->obstacle_of(object)) {
    throw std::invalid_argument(fmt::format("{} at ({:.3f}, {:.3f}) m would stand in {}",
                                            object.name, pose.x, pose.y, *obstacle));
  }
  check_path(impl_->model, object);
  return impl_->add_object(object);
}

void World::remove(BodyId id) {
  if (id >= body_count()) throw std::out_of_range(fmt::format("no body {}", id));
  if (!is_there(id)) return;
  Bodies& bodies = impl_->bodies;
  bodies.remove(id);
  bodies.response_[id] = {};
  impl_->note_slider(id);
  bodies.set_velocity(id, {});
  impl_->forget_contacts(id);
  impl_->stand(id);
}

std::size_t World::object_count() const { return impl_->things.size(); }

BodyId World::object_body(std::size_t object) const { return impl_->things.at(object).body; }

std::optional<std::size_t> World::object_of(BodyId id) const {
  const Impl::Thing* thing = impl_->thing_of(id);
  if (thing == nullptr) return std::nullopt;
  return static_cast<std::size_t>(thing - impl_->things.data());
}

bool World::is_free(const ObjectSpec& object, BodyId ignore) const {
  return !impl_->obstacle_of(object, ignore);
}

double World::rim_distance(BodyId id, Vec2 p) const { return impl_->gap_to_point(id, p); }

BodyShape World::shape(BodyId id) const { return impl_->bodies.shape_[id]; }
bool World::slides(BodyId id) const { return impl_->bodies.response_[id].slides; }

}  // namespace eyebridge::world
