#include <algorithm>
#include <cmath>
#include <limits>
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

[[noreturn]] void refuse(const ObjectSpec& object, const std::string& obstacle) {
  throw std::invalid_argument(fmt::format("{} at ({:.3f}, {:.3f}) m would stand in {}", object.name,
                                          object.pose.x, object.pose.y, obstacle));
}

}  // namespace

void World::Impl::check_free(const ObjectSpec& object) const {
  const Vec2 centre = object.pose.position();
  const double radius = object.outer_radius();
  const bool is_box = object.kind == ObjectKind::Box;
  const Rectangle box{centre, Heading::from_angle(object.pose.theta).forward(), 0.5 * object.size};
  double to_walls = std::numeric_limits<double>::infinity();
  if (!is_box) to_walls = walls.distance(centre, radius) - radius;
  walls.each_near(centre, radius, [&](std::uint32_t segment, double) {
    if (!is_box) return;
    to_walls =
        std::min(to_walls, separation(box, rectangle_of(walls.segments()[segment])).distance);
  });
  if (to_walls < -kTouching || walls.inside_thick(centre)) refuse(object, "a wall");
  const auto gap_to = [&](BodyId other) {
    if (!is_box) return gap_to_point(other, centre) - radius;
    if (bodies.shape_[other] == BodyShape::Box) {
      return separation(box, bodies.rectangle(other)).distance;
    }
    return distance_to(box, bodies.position(other)) - bodies.radius_[other];
  };
  BodyId met = kNoBody;
  bodies.each_on_way(centre, {}, radius, [&](BodyId other) {
    if (other < met && gap_to(other) < -kTouching) met = other;
  });
  if (met == kNoBody) return;
  const Vec2 place = bodies.position(met);
  refuse(object, fmt::format("{} at ({:.3f}, {:.3f}) m",
                             bodies.shape_[met] == BodyShape::Robot ? "a robot" : "another object",
                             place.x, place.y));
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
  impl_->check_free(object);
  // As for one that a file places: it would stand there for good and look like a wall.
  if (object.path && object.path->points == std::vector<Vec2>{pose.position()}) {
    throw std::invalid_argument("object: the only way-point is where it stands");
  }
  if (object.path && wall_on_path(*impl_->model, object)) {
    throw std::invalid_argument("object: its path leads into a wall");
  }
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
  impl_->contacts.forget(id);
  std::erase_if(impl_->movers, [&](const Mover& mover) { return mover.body == id; });
  std::erase_if(impl_->reactors, [&](const Reactor& reactor) { return reactor.body == id; });
}

void World::set_fixed(BodyId id, bool fixed) {
  const auto object = object_of(id);
  if (!object) throw std::out_of_range(fmt::format("body {} is no object's", id));
  if (is_there(id)) impl_->set_fixed(impl_->things[*object], fixed);
}

std::size_t World::object_count() const { return impl_->things.size(); }

BodyId World::object_body(std::size_t object) const { return impl_->things.at(object).body; }

std::optional<std::size_t> World::object_of(BodyId id) const {
  const Impl::Thing* thing = impl_->thing_of(id);
  if (thing == nullptr) return std::nullopt;
  return static_cast<std::size_t>(thing - impl_->things.data());
}

BodyShape World::shape(BodyId id) const { return impl_->bodies.shape_[id]; }
bool World::moves_by_itself(BodyId id) const {
  const Impl::Thing* thing = impl_->thing_of(id);
  return thing != nullptr && (thing->spec.path || thing->spec.reaction);
}
bool World::slides(BodyId id) const { return impl_->bodies.response_[id].slides; }

}  // namespace eyebridge::world
