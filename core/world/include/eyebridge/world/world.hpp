#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "eyebridge/base/hash.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/ray_caster.hpp"
#include "eyebridge/world/scene.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::world {

/// Index of a body in its World: 0 for the first one added.
using BodyId = std::uint32_t;
inline constexpr BodyId kNoBody = ~BodyId{0};

/// A driven body stops this far from what it meets, metres: room for rounding, so that bodies never
/// overlap a wall or each other, and too little for any sensor to see.
inline constexpr double kContactGap = 1e-7;

/// A motion over one step: an exact arc in the body's own frame.
struct Arc {
  Vec2 displacement;  ///< Chord, in the frame of the body at the start of the step, metres.
  Heading turn;       ///< Change of heading.
};

/// What a driven body does where something is in its way.
struct ContactLaw {
  bool slides = false;  ///< Along what it met; else it stands.
  bool turns = false;   ///< By all of the turn; else by as much of it as the way made progress.
  /// Coulomb's coefficient, >= 0: of a motion v at the angle a to the surface there remains
  /// v max(0, cos a - friction sin a) along it.
  double friction = 0.0;
};

/// What a move met.
struct MoveResult {
  double fraction = 1.0;  ///< How much of the way was driven until it met something, 0 … 1.
  bool hit_wall = false;
  BodyId hit_body = kNoBody;  ///< A body that did not give way.
  /// Direction of the contact in the world, unit vector from the body's centre; null if none.
  Vec2 contact;
  /// How far it came in the direction that it was driven in, 0 … 1 of the way.
  double progress = 1.0;
  bool slid = false;  ///< On along what it met.

  [[nodiscard]] bool blocked() const { return hit_wall || hit_body != kNoBody; }
};

/// A body that ran into something.
struct Bump {
  BodyId body = 0;         ///< The one that moved.
  BodyId other = kNoBody;  ///< What it met; kNoBody: a wall.
  Vec2 place;              ///< On the rim of `body`, in the world, metres.
};

/// So many fans are cast at once.
inline constexpr std::size_t kFansTogether = 16;

/// Rays from one place, or from places near it, which do not meet the body `ignore`; see
/// World::cast_fan(). The spans are lent for the call.
struct RayFan {
  Vec2 origin;                       ///< Metres.
  std::span<const Vec2> directions;  ///< Unit vectors.
  double max_range = 0.0;            ///< Metres.
  BodyId ignore = kNoBody;
  std::span<double> ranges;         ///< As many as directions.
  std::span<const Vec2> origins{};  ///< Where each begins, as many; empty: all at `origin`.
  double spread = 0.0;  ///< None of `origins` is farther from `origin` than so many metres.
};

/// Walls and bodies: who is where, who touches whom, how far a ray goes.
///
/// Robots, balls and cans are discs, boxes and polygons do not turn; state is struct-of-arrays.
/// A driven body stops at the contact, or slides on: ContactLaw. Objects give way unless they are
/// fixed. Objects and robots may be added and removed at any time. Same calls, same bits:
/// nothing here depends on addresses, threads or libm. Not thread-safe.
class World {
 public:
  /// Adds the model's objects as the first bodies, in order. Throws std::invalid_argument for one
  /// that cannot be: without size or mass, with a negative friction or a restitution above 1. What
  /// wanders draws from streams of `seed`.
  explicit World(std::shared_ptr<const WorldModel> model, std::uint64_t seed = 1);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Adds a robot's body. Throws std::invalid_argument when it overlaps a wall or a body;
  /// the message says which and by how much.
  BodyId add_robot(const Pose& pose, double radius, double height, Rgb colour);

  /// Adds an object while others move. Throws std::invalid_argument for one that cannot be, as the
  /// constructor does, and when it overlaps a wall or a body; the message says which.
  BodyId add_object(const ObjectSpec& object);
  /// Takes a body out of the world: nothing meets, touches or sees it any more, and it stays away.
  /// Its id is not used again; its pose is the last one it had. A second time does nothing. Throws
  /// std::out_of_range for an id that never was.
  void remove(BodyId id);
  /// False once it was removed.
  [[nodiscard]] bool is_there(BodyId id) const;

  /// With those that were removed.
  [[nodiscard]] std::size_t body_count() const;
  /// Of the model's objects, whose ids are 0 …, and of those that were added later; with those that
  /// were removed.
  [[nodiscard]] std::size_t object_count() const;
  /// Body of an object, by its number in the order in which they came, from 0. Throws
  /// std::out_of_range for one that never was.
  [[nodiscard]] BodyId object_body(std::size_t object) const;
  /// The number of the object that has this body; nothing for a robot's and for kNoBody.
  [[nodiscard]] std::optional<std::size_t> object_of(BodyId id) const;
  [[nodiscard]] BodyShape shape(BodyId id) const;
  [[nodiscard]] Pose pose(BodyId id) const;
  [[nodiscard]] Vec2 position(BodyId id) const;
  [[nodiscard]] Heading heading(BodyId id) const;
  /// Metres; of a box or polygon, that of the disc that covers it.
  [[nodiscard]] double radius(BodyId id) const;
  /// Whether robots push it away: objects, unless they are fixed or on a path.
  [[nodiscard]] bool gives_way(BodyId id) const;
  /// Metres per second, of what rolls or slides by itself; null for all others.
  [[nodiscard]] Vec2 velocity(BodyId id) const;
  /// Kicks what rolls or slides by itself; does nothing to others. `velocity` is finite.
  void set_velocity(BodyId id, Vec2 velocity);
  /// Whether it rolls or slides on by itself when it was hit: balls, and what has a friction,
  /// unless they are fixed or move by themselves.
  [[nodiscard]] bool slides(BodyId id) const;
  /// Whether an object has a path or a reaction.
  [[nodiscard]] bool moves_by_itself(BodyId id) const;
  /// From now on nothing pushes an object away, or what its kind and friction say does. What is
  /// fixed stops. Does nothing to one that moves by itself, or was removed. Throws
  /// std::out_of_range for what is no object's body.
  void set_fixed(BodyId id, bool fixed);
  /// An object as it is now: where it is, how it behaves. Throws std::out_of_range for what is no
  /// object's body.
  [[nodiscard]] ObjectSpec object(BodyId id) const;
  /// From now on an object behaves as `like` does: its matter, path, reaction and yields_within; a
  /// path begins where the object is. Its looks and its place stay, and the way that it is on,
  /// unless that is another one. Throws as add_object() does, but for room, and then changes
  /// nothing; std::out_of_range for what is no object's body. Does nothing to one that was removed.
  void change_object(BodyId id, const ObjectSpec& like);
  /// Puts a body somewhere, at rest. No check: a person may put it into a wall. One on a path goes
  /// on from there to the point that it was heading for. One that was removed stays away.
  void set_pose(BodyId id, const Pose& pose);

  /// Drives `id` along the chord of `arc`, up to the first contact that does not give way, and from
  /// there on as `law` says.
  ///
  /// A motion away from what the body touches, or parallel to it, is free; so is a turn on the
  /// spot. Within a wall (a person
  /// put it there) only motions that lead out are possible. Objects on the way are pushed along the
  /// normal of the contact (of discs: the line of centres), and slip aside when they are squeezed
  /// against a wall or a robot not too steeply; `dt` is the duration of the step in seconds, from
  /// which what rolls or slides gets its speed. `arc` is finite, and `id` is there.
  MoveResult move(BodyId id, const Arc& arc, double dt, const ContactLaw& law = {});
  /// Moves what moves by itself, rolls balls, and lets slide what slides, for `dt` seconds; called
  /// once a step, after the robots moved.
  void step_objects(double dt);

  /// Another number after each change of what rays meet: a body has moved, come or left.
  [[nodiscard]] std::uint64_t version() const;

  /// Range from `origin` along the unit vector `direction` to the nearest wall or body other than
  /// `ignore`, or `max_range`.
  [[nodiscard]] double cast_ray(Vec2 origin, Vec2 direction, double max_range, BodyId ignore) const;
  /// The same for many directions from one origin.
  void cast_fan(Vec2 origin, std::span<const Vec2> directions, double max_range, BodyId ignore,
                std::span<double> ranges) const;
  /// The same for many fans, in less time than one after the other: kFansTogether at once, where
  /// neighbours have up to 16 rays each and a spread of up to a metre.
  void cast_fans(std::span<const RayFan> fans) const;
  /// The same ranges, faster, for directions that are evenly spaced: each is the one before turned
  /// by `gap` radians, not 0, to either side, all of them one turn at most.
  void cast_sweep(Vec2 origin, std::span<const Vec2> directions, double gap, double max_range,
                  BodyId ignore, std::span<double> ranges) const;

  /// How squarely a ray along the unit vector `direction` that ended at `place` (its origin + range
  /// * direction, metres) met what it met there, other than `ignore`: the cosine of the angle of
  /// incidence, 1 head on, 0 along the surface. Of surfaces that meet there the largest one. 0
  /// where there is nothing within a micrometre.
  [[nodiscard]] double incidence_cosine(Vec2 place, Vec2 direction, BodyId ignore) const;

  /// Appends the contacts of `id` as unit vectors from its centre in the world: walls and bodies
  /// nearer than `reach` metres to its rim. What stopped it counts even with `reach` 0. Walls come
  /// first, then bodies in order of id; each direction once.
  void contacts(BodyId id, double reach, std::vector<Vec2>& out) const;

  /// The contacts that began in the last step, which step_objects() ended, in the order in which
  /// they happened: each once, until the two have been a millimetre apart. What a person puts
  /// together counts from the first motion against each other. Lent until the next step.
  [[nodiscard]] std::span<const Bump> bumps() const;

  /// True when a disc of `radius` at `centre` touches neither wall nor body (other than `ignore`).
  [[nodiscard]] bool is_free(Vec2 centre, double radius, BodyId ignore = kNoBody) const;
  /// The same of `object`, where it is placed.
  [[nodiscard]] bool is_free(const ObjectSpec& object, BodyId ignore = kNoBody) const;
  /// Distance from `p` to the rim of a body, metres; less than 0 within it.
  [[nodiscard]] double rim_distance(BodyId id, Vec2 p) const;

  [[nodiscard]] const WorldModel& model() const;
  /// Without those that were removed.
  [[nodiscard]] Scene scene(double time) const;
  void add_to(StateHash& hash) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::world
