// How an object behaves, once it is there.
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

bool goes_alike(const ObjectSpec& a, const ObjectSpec& b) {
  return a.path == b.path && a.reaction == b.reaction;
}

bool behaves_alike(const ObjectSpec& a, const ObjectSpec& b) {
  return goes_alike(a, b) && a.matter == b.matter && a.yields_within == b.yields_within;
}

/// Numbers that say how `object` behaves.
void add_behaviour(const ObjectSpec& object, StateHash& hash) {
  const Matter& matter = object.matter;
  for (const double value : {matter.mass, matter.friction.value_or(-1.0),
                             matter.restitution.value_or(-1.0), object.yields_within}) {
    hash.add(value);
  }
  hash.add(std::uint64_t{matter.fixed});
  if (object.path) {
    const Path& path = *object.path;
    for (const double value : {path.speed, path.acceleration}) hash.add(value);
    hash.add(std::uint64_t{path.loop});
    for (const Vec2 point : path.points) {
      for (const double value : {point.x, point.y}) hash.add(value);
    }
    for (const auto& values : {path.leg_speeds, path.waits}) {
      for (const double value : values) hash.add(value);
    }
  }
  if (object.reaction) {
    hash.add(static_cast<std::uint64_t>(object.reaction->kind));
    for (const double value : {object.reaction->speed, object.reaction->range}) hash.add(value);
  }
}

}  // namespace

void check_path(const WorldModel& model, const ObjectSpec& object) {
  if (!object.path) return;
  // As for one that a file places: it would stand there for good and look like a wall.
  if (object.path->points == std::vector<Vec2>{object.pose.position()}) {
    throw std::invalid_argument("object: the only way-point is where it stands");
  }
  if (wall_on_path(model, object)) {
    throw std::invalid_argument("object: its path leads into a wall");
  }
}

World::Impl::Thing& World::Impl::need_thing(BodyId id) {
  const auto found = std::ranges::lower_bound(things, id, {}, &Thing::body);
  if (found == things.end() || found->body != id) {
    throw std::out_of_range(fmt::format("body {} is no object's", id));
  }
  return *found;
}

void World::Impl::stand(BodyId id) {
  std::erase_if(movers, [&](const Mover& mover) { return mover.body == id; });
  std::erase_if(reactors, [&](const Reactor& reactor) { return reactor.body == id; });
}

void World::Impl::change(Thing& thing, const ObjectSpec& like) {
  if (!thing.first) thing.first = std::make_unique<const ObjectSpec>(thing.spec);
  const bool same_way = goes_alike(thing.spec, like);
  thing.spec.matter = like.matter;
  thing.spec.path = like.path;
  thing.spec.reaction = like.reaction;
  thing.spec.yields_within = like.yields_within;
  const BodyId id = thing.body;
  bodies.response_[id] = response_of(thing.spec);
  if (!bodies.response_[id].slides) bodies.set_velocity(id, {});
  note_slider(id);
  if (same_way) {
    for (Mover& mover : movers) {
      if (mover.body == id) mover.yields_within = like.yields_within;
    }
    for (Reactor& reactor : reactors) {
      if (reactor.body == id) reactor.yields_within = like.yields_within;
    }
    return;
  }
  stand(id);
  ObjectSpec here = thing.spec;
  const Vec2 place = bodies.position(id);
  here.pose = {place.x, place.y, here.pose.theta};
  if (here.path) add_mover(id, here);
  if (here.reaction) add_reactor(id, here);
}

ObjectSpec World::object(BodyId id) const {
  ObjectSpec object = impl_->need_thing(id).spec;
  object.pose = pose(id);
  return object;
}

void World::change_object(BodyId id, const ObjectSpec& like) {
  Impl::Thing& thing = impl_->need_thing(id);
  if (!is_there(id)) return;
  ObjectSpec changed = object(id);
  const bool same_path = like.path == changed.path;
  changed.matter = like.matter;
  changed.path = like.path;
  changed.reaction = like.reaction;
  changed.yields_within = like.yields_within;
  check_object(changed);
  if (!same_path) check_path(impl_->model, changed);
  impl_->change(thing, changed);
}

void World::set_fixed(BodyId id, bool fixed) {
  ObjectSpec changed = object(id);
  if (!is_there(id) || moves_by_itself(id)) return;
  changed.matter.fixed = fixed;
  impl_->change(impl_->need_thing(id), changed);
}

bool World::moves_by_itself(BodyId id) const {
  const Impl::Thing* thing = impl_->thing_of(id);
  return thing != nullptr && (thing->spec.path || thing->spec.reaction);
}

void World::Impl::add_changes(StateHash& hash) const {
  for (const Thing& thing : things) {
    if (!thing.first) continue;
    // Where a way was begun that was given later.
    for (const Mover& mover : movers) {
      if (mover.body != thing.body) continue;
      for (const double value : {mover.stops.front().x, mover.stops.front().y}) hash.add(value);
    }
    if (behaves_alike(*thing.first, thing.spec)) continue;
    hash.add(std::uint64_t{thing.body});
    add_behaviour(thing.spec, hash);
  }
}

}  // namespace eyebridge::world
