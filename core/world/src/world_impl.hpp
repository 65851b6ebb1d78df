#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bodies.hpp"
#include "body_map.hpp"
#include "contacts.hpp"
#include "eyebridge/world/world.hpp"
#include "fan.hpp"
#include "paths.hpp"
#include "reactions.hpp"
#include "standing_walls.hpp"
#include "sweep.hpp"

namespace eyebridge::world {

/// No body is farther away than this, metres: infinite ranges need an end.
inline constexpr double kHorizon = 1e9;

struct World::Impl {
  Impl(std::shared_ptr<const WorldModel> world_model, std::uint64_t run_seed);

  /// An object, in the order in which they came.
  struct Thing {
    BodyId body = kNoBody;
    ObjectSpec spec;  ///< As it was added, with the behaviour that it has now.
    std::unique_ptr<const ObjectSpec> first{};  ///< As it was added, once that has changed.
  };

  /// What a body's way ends at.
  struct Obstacle {
    double fraction = kNoContact;
    bool wall = false;
    std::uint32_t segment = 0;  ///< Of `walls`, when `wall`.
    BodyId body = kNoBody;      ///< Otherwise.

    [[nodiscard]] bool met() const { return fraction <= 1.0; }
  };

  // matter.cpp
  BodyId add_object(const ObjectSpec& object);
  /// Keeps `sliders` when `id` has begun or ended to be one.
  void note_slider(BodyId id);

  // objects.cpp
  /// What `object` would stand in, in words; nothing where it is free.
  [[nodiscard]] std::optional<std::string> obstacle_of(const ObjectSpec& object,
                                                       BodyId ignore = kNoBody) const;
  [[nodiscard]] const Thing* thing_of(BodyId id) const;
  /// Throws std::out_of_range for what is no object's body.
  [[nodiscard]] Thing& need_thing(BodyId id);

  // change.cpp
  void change(Thing& thing, const ObjectSpec& like);
  /// It moves by itself no more.
  void stand(BodyId id);
  /// What is no longer as it was when it was added.
  void add_changes(StateHash& hash) const;

  // motion.cpp
  MoveResult drive(BodyId id, Vec2 motion, double dt);
  /// The result of a drive that ended at `end` after `fraction` of the motion.
  MoveResult stopped(BodyId id, double fraction, const Obstacle& end);
  /// slide.cpp. Goes on after a drive by `motion` that ended as `result` says, and notes in it how
  /// far.
  void slide(BodyId id, Vec2 motion, double dt, double friction, MoveResult& result);
  /// First wall on the way of `id` along `motion`. Keeps the clearance; the caller must go on to
  /// travelled() for the way that the body really goes.
  Obstacle first_wall(BodyId id, Vec2 motion);
  /// First body on the way for which `blocks(other)` holds, and first one for which it does not;
  /// the lowest id of equally near ones. Remembers how far away the others are at all.
  template <class Blocks>
  [[nodiscard]] std::pair<Obstacle, Obstacle> first_bodies(BodyId id, Vec2 motion, Blocks blocks);
  /// First wall or body of any kind on the way.
  Obstacle first_obstacle(BodyId id, Vec2 motion);
  /// True when a motion that `hold` is of fails as it did.
  [[nodiscard]] bool still_holds(const Hold& hold) const;
  /// Moves `id`, and takes the way off its clearance.
  void travel(BodyId id, Vec2 motion) { travel(id, motion, norm(motion)); }
  /// Same, where the length of `motion` is known.
  void travel(BodyId id, Vec2 motion, double length);
  /// Shifts what gives way by `motion`, and what it pushes before it; how much of it was possible.
  double shift(BodyId id, Vec2 motion, double dt, int depth);
  /// Moves what is squeezed against something in the direction of `normal` aside, so
  /// far that its pusher can go on by `motion`; false when it jams.
  bool slip(BodyId id, Vec2 motion, Vec2 normal);
  /// Unit vector from `id` to the obstacle that it touches.
  [[nodiscard]] Vec2 towards(const Obstacle& obstacle, BodyId id) const;
  /// Gives what slides the speed that a hit by something driven at `velocity` along `normal` gives.
  void kick(BodyId id, Vec2 velocity, Vec2 normal);

  // paths.cpp
  void add_mover(BodyId id, const ObjectSpec& object);
  /// Moves it for `dt` seconds, or up to what stops it.
  void follow(Mover& mover, double dt);
  /// The same for one with a profile of speeds, and waits.
  void follow_profile(Mover& mover, double dt);

  // reactions.cpp
  void add_reactor(BodyId id, const ObjectSpec& object);
  void react(Reactor& reactor, double dt);
  /// The robot whose rim is nearest to that of `id`, and no farther than `range` metres; the lowest
  /// id of equally near ones; or kNoBody.
  [[nodiscard]] BodyId nearest_robot(BodyId id, double range) const;

  // contacts.cpp
  /// Remembers that `id` ran into `end`.
  void note(BodyId id, const Obstacle& end);
  /// What held them to each other (kNoBody: to a wall) holds no more.
  void end_contact(BodyId id, BodyId other);
  void forget_contacts(BodyId id) {
    contacts.forget(id, [this](BodyId a, BodyId b) { end_contact(a, b); });
  }
  /// Between the rims of two bodies, or of a body and the walls (kNoBody), metres.
  [[nodiscard]] double gap(BodyId id, BodyId other) const;
  [[nodiscard]] double wall_gap(BodyId id) const;

  // sensing.cpp
  /// Whether they are what cast_few() is for: up to Fan::kMost rays, from places near each other.
  [[nodiscard]] bool are_few(const RayFan& fan) const;
  /// How far the rays of `fan` go until they meet walls.
  void cast_at_walls(const RayFan& fan, std::span<double> ranges) const;
  /// World::cast_fans(), for 1 to kFansTogether fans that are few; false in worlds that are too
  /// large for it.
  bool cast_few(std::span<const RayFan> asked);
  /// World::cast_sweep(), for at most Sweep::kMost rays; without a `gap` in any directions.
  void cast_around(Vec2 origin, std::span<const Vec2> directions, double gap, double max_range,
                   BodyId ignore, std::span<double> ranges);

  // convex_rays.cpp
  /// Shortens the rays that meet a box or polygon other than `ignore`.
  void meet_convex(Sweep& sweep, BodyId ignore) const;
  void meet_convex(const RayFan& fan) const;
  /// nearer_convex_hit() of a box or polygon.
  [[nodiscard]] double nearer_body_hit(BodyId id, Vec2 origin, Vec2 direction, double best) const;

  // balls.cpp
  void roll(BodyId id, double dt);
  void bounce_off(BodyId id, const Obstacle& end);

  // convex_contacts.cpp: the same questions where one with an outline is among those that meet
  [[nodiscard]] double convex_pair_contact(BodyId id, BodyId other, Vec2 motion) const;
  Obstacle first_wall_of_convex(BodyId id, Vec2 motion);
  [[nodiscard]] Vec2 towards_convex(const Obstacle& obstacle, BodyId id) const;
  /// Distance from `p` to the rim of `id`, metres; less than 0 within it.
  [[nodiscard]] double gap_to_point(BodyId id, Vec2 p) const;

  [[nodiscard]] bool gives_way(BodyId id) const { return bodies.response_[id].gives_way; }

  std::shared_ptr<const StandingWalls> standing_walls;
  const WorldModel& model;
  const WallIndex& walls;
  const RayCaster& rays;
  Bodies bodies;
  std::uint64_t seed;
  std::vector<Thing> things;
  std::vector<BodyId> sliders;  ///< Of the things those that roll or slide, in order.
  std::vector<Mover> movers;
  std::vector<Reactor> reactors;
  ContactBook contacts;
  BodyMap body_map;
  std::vector<Fan> fans;  ///< Of the look at hand; kept for its memory.
};

/// Throws std::invalid_argument for an object that cannot be.
void check_object(const ObjectSpec& object);
/// The same for one whose path leads nowhere, or into a wall of `model`.
void check_path(const WorldModel& model, const ObjectSpec& object);
/// How it answers to pushes and hits.
Response response_of(const ObjectSpec& object);

/// Unit vector from `from` to `to`; null where they are one.
inline Vec2 direction_to(Vec2 to, Vec2 from) {
  const Vec2 way = to - from;
  const double distance = norm(way);
  return distance > 0.0 ? Vec2{way.x / distance, way.y / distance} : Vec2{};
}

template <class Blocks>
std::pair<World::Impl::Obstacle, World::Impl::Obstacle> World::Impl::first_bodies(BodyId id,
                                                                                  Vec2 motion,
                                                                                  Blocks blocks) {
  constexpr double kSlack = 1e-6;  // metres; far more than the rounding of all that was driven
  std::pair<Obstacle, Obstacle> best;
  const double length = norm(motion);
  if (bodies.is_alone(id, length)) return best;
  const Vec2 from = bodies.position(id);
  const double reach = bodies.radius_[id] + kContactGap;
  const double horizon = std::max(bodies.horizon(), length + kSlack);
  double gap = horizon;
  bodies.each_on_way(from, {}, reach + horizon, [&](BodyId other) {
    if (other == id) return;
    const Vec2 away = from - bodies.position(other);
    const double touching = reach + bodies.radius_[other];
    const double others_gap = norm(away) - touching;
    if (others_gap < gap) gap = others_gap;
    if (others_gap > length + kSlack) return;
    const double fraction = bodies.convex_among(id, other) ? convex_pair_contact(id, other, motion)
                                                           : disc_contact(away, motion, touching);
    if (fraction > 1.0) return;
    Obstacle& first = blocks(other) ? best.first : best.second;
    if (fraction < first.fraction || (fraction == first.fraction && other < first.body)) {
      first = {fraction, false, 0, other};
    }
  });
  bodies.set_free(id, gap - kSlack);
  return best;
}

}  // namespace eyebridge::world
