#include "paths.hpp"

#include "convex.hpp"
#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

std::vector<Vec2> stops_of(const ObjectSpec& object) {
  std::vector<Vec2> stops{object.pose.position()};
  stops.insert(stops.end(), object.path->points.begin(), object.path->points.end());
  return stops;
}

/// Whether `object`, moved to `from`, meets `wall` on its way along `motion`; `outline` is that of
/// what is no disc.
bool meets(const ObjectSpec& object, const Outline& outline, Vec2 from, Vec2 motion,
           const Segment& wall) {
  if (shape_of(object.kind) != BodyShape::Polygon) {
    return wall_contact(wall, from, motion, object.radius + kContactGap) <= 1.0;
  }
  const Vec2 forward = Heading::from_angle(object.pose.theta).forward();
  const Convex shape(outline, from, forward);
  return convex_contact(shape, Convex(wall), motion, kContactGap) <= 1.0;
}

}  // namespace

void Mover::turn_to_next() {
  if (loop) {
    target = (target + 1) % stops.size();
    return;
  }
  if (target + 1 == stops.size()) forward = false;
  if (target == 0) forward = true;
  target = forward ? target + 1 : target - 1;
}

void World::Impl::follow(Mover& mover, double dt) {
  if (mover.yields_within > 0.0 && nearest_robot(mover.body, mover.yields_within) != kNoBody) {
    mover.present = 0.0;
    return;
  }
  if (!mover.profile.empty()) return follow_profile(mover, dt);
  double left = mover.speed * dt;
  // A way of no length would have no end; one that goes somewhere gets there in two rounds.
  for (std::size_t legs = 0; left > 0.0 && legs < 2 * mover.stops.size(); ++legs) {
    const Vec2 way = mover.stops[mover.target] - bodies.position(mover.body);
    const double length = norm(way);
    const bool arrives = length <= left;
    const Vec2 motion = arrives ? way : (left / length) * way;
    if (length > 0.0 && drive(mover.body, motion, dt).blocked()) return;  // it tries again
    if (!arrives) return;
    left -= length;
    mover.turn_to_next();
  }
}

void World::Impl::add_mover(BodyId id, const ObjectSpec& object) {
  const Path& path = *object.path;
  Mover mover{id, path.speed, path.loop, stops_of(object)};
  mover.yields_within = object.yields_within;
  mover.acceleration = path.acceleration;
  mover.profile = profile_of(path, mover.stops);
  movers.push_back(std::move(mover));
}

std::optional<std::size_t> wall_on_path(const WorldModel& model, const ObjectSpec& object) {
  const std::vector<Vec2> stops = stops_of(object);
  const std::size_t legs = object.path->loop ? stops.size() : stops.size() - 1;
  const Outline outline(corners_of(object));
  for (std::size_t i = 0; i < model.walls.size(); ++i) {
    for (const Segment& segment : outlines_of({model.walls[i]})) {
      for (std::size_t leg = 0; leg < legs; ++leg) {
        const Vec2 motion = stops[(leg + 1) % stops.size()] - stops[leg];
        if (meets(object, outline, stops[leg], motion, segment)) return i;
      }
    }
  }
  return std::nullopt;
}

}  // namespace eyebridge::world
