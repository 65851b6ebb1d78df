#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "convex.hpp"
#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/scene.hpp"
#include "eyebridge/world/world.hpp"

namespace eyebridge::world {

/// A motion that a wall, or a body that gives no way, did not allow at all. Whoever tries it again
/// from there fails again, as long as that body stays where it is and gives no way. It is forgotten
/// when the contact ends, so that the next one is told of.
struct Hold {
  Vec2 from{std::numeric_limits<double>::quiet_NaN(), 0.0};
  Vec2 motion;
  Vec2 contact;               ///< As in MoveResult.
  std::uint32_t segment = 0;  ///< Of the wall;
  BodyId body = kNoBody;      ///< or the body,
  Vec2 place;                 ///< and where that is.
  std::uint32_t round = 0;    ///< Of the bodies, in which it was tried again last.
};

/// How a body answers to pushes and hits: what an object's Matter comes to. Robots give no way.
struct Response {
  bool gives_way = false;  ///< To robots, and to what they push.
  bool slides = false;     ///< Goes on by itself when it was hit; implies `gives_way`.
  double mass = 1.0;
  double deceleration = 0.0;  ///< Of what slides, metres per second squared.
  double bounce = 0.0;        ///< Restitution when it meets something,
  double kick = 0.0;          ///< and when something that is driven hits it.
};

/// How long a body surely meets no other one, and how far it went in a round.
struct Freedom {
  double until = 0.0;       ///< Reading of the odometer of rounds, see Bodies; metres.
  double path = 0.0;        ///< Of `round`, metres.
  std::uint32_t round = 0;  ///< Rounds are counted modulo 2^32.
  std::uint32_t epoch = 0;  ///< `until` holds while this is that of the bodies.
};

/// The bodies of a world, struct-of-arrays, and who is near a place.
///
/// From kGridFrom bodies on, and once one was removed, a uniform grid of linked lists answers
/// instead of a loop over all.
/// Both visit a superset of what is near; callers pick by value and id, never by order of visits,
/// so the results do not depend on which of them answered.
///
/// Who had a look at its neighbours need not look again before two bodies can have covered the gap
/// to the nearest one. The odometer of rounds says how far anyone can have come: it grows in each
/// round by the longest path that any body went. A round ends when the owner says so, else never,
/// and all only look more often.
class Bodies {
 public:
  static constexpr std::size_t kGridFrom = 16;

  /// The grid covers the floor, `width` x `height` metres; bodies outside belong to its rim.
  Bodies(double width, double height) : extent_{width, height} {}

  BodyId add(BodyShape shape, Vec2 position, Heading heading, double radius, double height,
             Rgb colour);
  /// Takes it out of the world: no visit finds it any more. The others keep their ids.
  void remove(BodyId id);
  [[nodiscard]] bool is_there(BodyId id) const { return cell_[id] != kNoCell; }
  /// `length` metres along a way.
  void travel_to(BodyId id, Vec2 position, double length) {
    Freedom& freedom = freedom_[id];
    if (freedom.round != round_) {
      freedom.round = round_;
      freedom.path = 0.0;
    }
    // The factor is more than the rounding of the length.
    freedom.path += length * (1.0 + 1e-12);
    if (freedom.path > longest_path_) longest_path_ = freedom.path;
    move_to(id, position);
  }
  /// From anywhere to anywhere.
  void jump_to(BodyId id, Vec2 position) {
    ++epoch_;
    move_to(id, position);
  }
  void end_round() {
    odometer_ += longest_path_;
    longest_path_ = 0.0;
    ++round_;
  }

  /// True when `id` surely meets no body on the next `length` metres.
  [[nodiscard]] bool is_alone(BodyId id, double length) const {
    const Freedom& freedom = freedom_[id];
    // Both may have come nearer by what the odometer shows, and one goes `length` now.
    return freedom.epoch == epoch_ && odometer_ + longest_path_ + 0.5 * length < freedom.until;
  }
  /// How far around them bodies look for others, metres; so far at least that it pays.
  [[nodiscard]] double horizon() const { return horizon_; }
  /// Whoever looked found no body whose rim is nearer than `gap` metres to that of `id`.
  void set_free(BodyId id, double gap) {
    freedom_[id].epoch = epoch_;
    freedom_[id].until = odometer_ + 0.5 * gap;
  }

  /// Ended by end_round(); counted modulo 2^32.
  [[nodiscard]] std::uint32_t round() const { return round_; }

  [[nodiscard]] std::size_t size() const { return x_.size(); }
  [[nodiscard]] double largest_radius() const { return largest_radius_; }  ///< Metres.
  /// Another number after each change of a place; never 0 once there is a body.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  [[nodiscard]] Vec2 position(BodyId id) const { return {x_[id], y_[id]}; }
  [[nodiscard]] Vec2 velocity(BodyId id) const { return {vx_[id], vy_[id]}; }
  void set_velocity(BodyId id, Vec2 v) {
    vx_[id] = v.x;
    vy_[id] = v.y;
  }

  /// Calls visit(id) once for each body whose centre may lie in the box, and maybe for others.
  template <class Visit>
  void each_in_box(Vec2 low, Vec2 high, Visit visit) const {
    if (heads_.empty()) {
      for (BodyId id = 0; id < size(); ++id) visit(id);
      return;
    }
    const std::size_t last_column = cell_of(high.x, columns_);
    const std::size_t last_row = cell_of(high.y, rows_);
    for (std::size_t row = cell_of(low.y, rows_); row <= last_row; ++row) {
      for (std::size_t column = cell_of(low.x, columns_); column <= last_column; ++column) {
        for (BodyId id = heads_[row * columns_ + column]; id != kNoBody; id = next_[id]) visit(id);
      }
    }
  }
  /// Same for bodies that may come within `reach` of a disc's rim on its way along `motion`.
  template <class Visit>
  void each_on_way(Vec2 from, Vec2 motion, double reach, Visit visit) const {
    const double margin = reach + largest_radius_;
    const Vec2 to = from + motion;
    each_in_box(
        {(from.x < to.x ? from.x : to.x) - margin, (from.y < to.y ? from.y : to.y) - margin},
        {(from.x < to.x ? to.x : from.x) + margin, (from.y < to.y ? to.y : from.y) + margin},
        visit);
  }

  /// Same for bodies that may touch the straight way from `from` along `way`, which is finite.
  template <class Visit>
  void each_on_ray(Vec2 from, Vec2 way, Visit visit) const {
    const Vec2 to = from + way;
    const double margin = largest_radius_ + 1e-6;  // more than rounding makes of a place
    const double cell = 1.0 / per_cell_;
    const std::size_t last_row = cell_of((from.y < to.y ? to.y : from.y) + margin, rows_);
    std::size_t row = cell_of((from.y < to.y ? from.y : to.y) - margin, rows_);
    if (heads_.empty() || row == last_row) {
      each_on_way(from, way, 1e-6, visit);
      return;
    }
    for (; row <= last_row; ++row) {
      // The part of the way from which a body of this row can be touched; the rim has no end.
      const double low = row == 0 ? -kEndless : static_cast<double>(row) * cell - margin;
      const double high =
          row + 1 == rows_ ? kEndless : static_cast<double>(row + 1) * cell + margin;
      const double enter = std::clamp(((way.y > 0.0 ? low : high) - from.y) / way.y, 0.0, 1.0);
      const double leave = std::clamp(((way.y > 0.0 ? high : low) - from.y) / way.y, 0.0, 1.0);
      const double x0 = from.x + enter * way.x;
      const double x1 = from.x + leave * way.x;
      const std::size_t last = cell_of((x0 < x1 ? x1 : x0) + margin, columns_);
      for (std::size_t c = cell_of((x0 < x1 ? x0 : x1) - margin, columns_); c <= last; ++c) {
        for (BodyId id = heads_[row * columns_ + c]; id != kNoBody; id = next_[id]) visit(id);
      }
    }
  }

  // Read by everyone, written by the owner of the state.
  std::vector<double> cos_, sin_;  ///< Headings.
  std::vector<double> radius_;     ///< Metres.
  std::vector<double> height_;     ///< Metres.
  std::vector<double> clearance_;  ///< Metres the body may surely travel without meeting a wall.
  std::vector<Hold> hold_;         ///< What holds the body.
  std::vector<BodyShape> shape_;
  std::vector<Rgb> colour_;
  std::vector<Response> response_;
  std::vector<std::shared_ptr<const Outline>> outline_;  ///< Null for discs.
  bool any_convex_ = false;  ///< Else nothing but discs needs to be thought of.

  /// Whether it has an outline, and is no disc.
  [[nodiscard]] bool is_convex(BodyId id) const { return shape_[id] == BodyShape::Polygon; }
  /// Whether one of them has.
  [[nodiscard]] bool convex_among(BodyId a, BodyId b) const {
    return any_convex_ && (is_convex(a) || is_convex(b));
  }
  [[nodiscard]] Convex convex(BodyId id) const {
    return {*outline_[id], position(id), {cos_[id], sin_[id]}};
  }

 private:
  static constexpr std::size_t kNoCell = std::numeric_limits<std::size_t>::max();
  static constexpr double kEndless = std::numeric_limits<double>::infinity();

  /// Places outside, and NaNs, belong to the rim.
  [[nodiscard]] std::size_t cell_of(double coordinate, std::size_t count) const {
    const double index = coordinate * per_cell_;
    if (!(index > 0.0)) return 0;
    return index < static_cast<double>(count) ? static_cast<std::size_t>(index) : count - 1;
  }
  [[nodiscard]] std::size_t cell_at(Vec2 p) const {
    return cell_of(p.y, rows_) * columns_ + cell_of(p.x, columns_);
  }
  void move_to(BodyId id, Vec2 position) {
    ++version_;
    x_[id] = position.x;
    y_[id] = position.y;
    if (heads_.empty()) return;
    const std::size_t cell = cell_at(position);
    if (cell == cell_[id]) return;
    unlink(id);
    link(id, cell);
  }
  void rebuild_grid();
  void link(BodyId id, std::size_t cell);
  void unlink(BodyId id);

  std::vector<double> x_, y_;    ///< Centres, metres.
  std::vector<double> vx_, vy_;  ///< Metres per second; balls only.
  Vec2 extent_;
  double largest_radius_ = 0.0;
  double horizon_ = kEndless;
  std::uint64_t version_ = 0;
  std::vector<Freedom> freedom_;
  double odometer_ = 0.0;      ///< Of the rounds that are over, metres.
  double longest_path_ = 0.0;  ///< Of this round, metres.
  std::uint32_t round_ = 0;
  std::uint32_t epoch_ = 1;  ///< Changes when somebody jumps or is added.
  double per_cell_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<BodyId> heads_;  ///< Cell -> its first body; empty while there is no grid.
  std::vector<BodyId> next_;   ///< Body -> next one of its cell.
  std::vector<BodyId> previous_;
  std::vector<std::size_t> cell_;  ///< kNoCell for one that was removed.
};

}  // namespace eyebridge::world
