#include "eyebridge/world/world.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "world_impl.hpp"

namespace eyebridge::world {

World::Impl::Impl(std::shared_ptr<const WorldModel> world_model, std::uint64_t run_seed)
    : standing_walls(StandingWalls::of(std::move(world_model))),
      model(*standing_walls->model),
      walls(standing_walls->index),
      rays(standing_walls->rays),
      bodies(model.width, model.height),
      seed(run_seed),
      body_map(model.width, model.height) {
  for (const ObjectSpec& object : model.objects) add_object(object);
}

World::World(std::shared_ptr<const WorldModel> model, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(std::move(model), seed)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

/// What a state's hash has of a body that was removed, beside its place.
constexpr std::uint64_t kAway = 0x6177'6179;

// Metres. A robot as wide as a cell touches its walls, whatever rounding made of their places.
constexpr double kTouch = 1e-9;

BodyId World::add_robot(const Pose& pose, double radius, double height, Rgb colour) {
  Bodies& bodies = impl_->bodies;
  const Vec2 centre = pose.position();
  const double gap = impl_->walls.distance(centre, radius);
  if (gap < radius - kTouch || impl_->walls.inside_thick(centre)) {
    const double depth = impl_->walls.inside_thick(centre) ? radius + gap : radius - gap;
    throw std::invalid_argument(
        fmt::format("robot of radius {:.3f} m at ({:.3f}, {:.3f}) stands {:.4f} m deep in a wall",
                    radius, centre.x, centre.y, depth));
  }
  BodyId met = kNoBody;
  const auto overlap_with = [&](BodyId other) {
    return bodies.convex_among(other, other)
               ? radius - impl_->gap_to_point(other, centre)
               : radius + bodies.radius_[other] - norm(centre - bodies.position(other));
  };
  bodies.each_on_way(centre, {}, radius, [&](BodyId other) {
    if (other < met && overlap_with(other) > kTouch) met = other;
  });
  if (met != kNoBody) {
    throw std::invalid_argument(fmt::format(
        "robot of radius {:.3f} m at ({:.3f}, {:.3f}) overlaps body {} at ({:.3f}, {:.3f}) by "
        "{:.4f} m",
        radius, centre.x, centre.y, met, bodies.position(met).x, bodies.position(met).y,
        overlap_with(met)));
  }
  return bodies.add(BodyShape::Robot, centre, Heading::from_angle(pose.theta), radius, height,
                    colour);
}

bool World::is_there(BodyId id) const { return impl_->bodies.is_there(id); }

std::size_t World::body_count() const { return impl_->bodies.size(); }

Pose World::pose(BodyId id) const {
  const Vec2 p = position(id);
  return {p.x, p.y, heading(id).angle()};
}
std::uint64_t World::version() const { return impl_->bodies.version(); }
Vec2 World::position(BodyId id) const { return impl_->bodies.position(id); }
Heading World::heading(BodyId id) const { return {impl_->bodies.cos_[id], impl_->bodies.sin_[id]}; }
double World::radius(BodyId id) const { return impl_->bodies.radius_[id]; }
bool World::gives_way(BodyId id) const { return impl_->gives_way(id); }
Vec2 World::velocity(BodyId id) const { return impl_->bodies.velocity(id); }

void World::set_velocity(BodyId id, Vec2 velocity) {
  if (impl_->bodies.response_[id].slides) impl_->bodies.set_velocity(id, velocity);
}

void World::set_pose(BodyId id, const Pose& pose) {
  Bodies& bodies = impl_->bodies;
  if (!bodies.is_there(id)) return;
  bodies.jump_to(id, pose.position());
  const Heading heading = Heading::from_angle(pose.theta);
  bodies.cos_[id] = heading.cos;
  bodies.sin_[id] = heading.sin;
  bodies.set_velocity(id, {});
  bodies.clearance_[id] = 0.0;
  bodies.hold_[id] = {};
  for (Mover& mover : impl_->movers) {
    if (mover.body == id) mover.present = 0.0;
  }
  impl_->forget_contacts(id);
}

const WorldModel& World::model() const { return impl_->model; }

Scene World::scene(double time) const {
  Scene scene{impl_->standing_walls->model, {}, time};
  scene.bodies.reserve(body_count());
  for (BodyId id = 0; id < body_count(); ++id) {
    if (!is_there(id)) continue;
    BodyView& view = scene.bodies.emplace_back();
    view = {id,
            impl_->bodies.shape_[id],
            pose(id),
            impl_->bodies.radius_[id],
            impl_->bodies.height_[id],
            impl_->bodies.colour_[id]};
    const std::shared_ptr<const Outline>& outline = impl_->bodies.outline_[id];
    if (outline) view.corners = {outline, &outline->corners};
  }
  return scene;
}

void World::add_to(StateHash& hash) const {
  for (BodyId id = 0; id < body_count(); ++id) {
    if (!is_there(id)) hash.add(kAway);
    const Vec2 p = position(id);
    const Vec2 v = impl_->bodies.velocity(id);
    const Heading h = heading(id);
    for (const double value : {p.x, p.y, h.cos, h.sin, v.x, v.y}) hash.add(value);
  }
  for (const Mover& mover : impl_->movers) {
    hash.add(std::uint64_t{mover.target});
    hash.add(std::uint64_t{mover.forward});
    if (mover.profile.empty()) continue;
    hash.add(mover.present);
    hash.add(mover.waits);
  }
  for (const Reactor& reactor : impl_->reactors) {
    for (const double value : {reactor.direction.x, reactor.direction.y}) hash.add(value);
    hash.add(reactor.bounces);
  }
  impl_->add_changes(hash);
}

}  // namespace eyebridge::world
