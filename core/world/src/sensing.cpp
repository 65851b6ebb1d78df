#include <algorithm>
#include <array>

#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

/// Directions nearer to each other than this (radians) are one contact: two walls meet there.
constexpr double kSameDirection = 1e-6;

/// In worlds where floats are off by more than this, metres, they are of no use.
constexpr double kCoarse = 0.1;

double farthest_of(std::span<const double> ranges) {
  return std::min(*std::max_element(ranges.begin(), ranges.end()), kHorizon);
}

void add_once(Vec2 direction, std::size_t first, std::vector<Vec2>& out) {
  for (std::size_t i = first; i < out.size(); ++i) {
    if (norm_squared(out[i] - direction) < kSameDirection * kSameDirection) return;
  }
  out.push_back(direction);
}

}  // namespace

bool World::Impl::are_few(const RayFan& fan) const {
  return !fan.directions.empty() && fan.directions.size() <= Fan::kMost &&
         fan.spread <= Fan::kMostSpread;
}

void World::Impl::cast_at_walls(const RayFan& fan, std::span<double> ranges) const {
  if (fan.origins.empty()) {
    rays.cast_fan(fan.origin, fan.directions, fan.max_range, ranges);
    return;
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    rays.cast_fan(fan.origins[i], fan.directions.subspan(i, 1), fan.max_range,
                  ranges.subspan(i, 1));
  }
}

bool World::Impl::cast_few(std::span<const RayFan> asked) {
  body_map.refresh(bodies);
  // Look up all first: the processor then fetches the walls of many fans at the same time.
  std::array<std::optional<WallList>, kFansTogether> near;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const RayFan& ray = asked[i];
    if (body_map.error(ray.origin) >= kCoarse) return false;
    if (!standing_walls->by_sweep) continue;
    near[i] = standing_walls->near.around(ray.origin, Fan::reach_of(ray));
    if (near[i]) __builtin_prefetch(near[i]->ends);
  }
  fans.clear();
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const RayFan& ray = asked[i];
    Fan& fan = fans.emplace_back(ray, body_map.place_of(ray.ignore));
    if (near[i]) {
      fan.meet_walls(standing_walls->near.segments().data(), *near[i]);
    } else {
      cast_at_walls(ray, fan.ranges());
    }
  }
  Fan::meet_discs(fans, body_map, bodies.largest_radius());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    std::copy_n(fans[i].ranges().begin(), asked[i].ranges.size(), asked[i].ranges.begin());
    if (bodies.any_convex_) meet_convex(asked[i]);
  }
  fans.clear();  // the directions are lent
  return true;
}

void World::Impl::cast_around(Vec2 origin, std::span<const Vec2> directions, double gap,
                              double max_range, BodyId ignore, std::span<double> ranges) {
  body_map.refresh(bodies);
  const BodyMap::Hidden hidden(body_map, ignore);
  Sweep sweep(origin, directions, gap, max_range);
  const auto walls_near =
      standing_walls->by_sweep ? standing_walls->near.around(origin, max_range) : std::nullopt;
  if (!walls_near) {
    rays.cast_fan(origin, directions, max_range, sweep.ranges());
  } else {
    sweep.meet_walls(standing_walls->near.segments().data(), *walls_near);
  }
  if (body_map.error(origin) >= kCoarse) {
    const double reach = farthest_of(sweep.ranges()) + bodies.largest_radius();
    sweep.meet_discs(body_map.around(origin, reach), ignore);
  } else {
    sweep.meet_discs(body_map, bodies.largest_radius());
  }
  if (bodies.any_convex_) meet_convex(sweep, ignore);
  std::copy_n(sweep.ranges().begin(), ranges.size(), ranges.begin());
}

double World::cast_ray(Vec2 origin, Vec2 direction, double max_range, BodyId ignore) const {
  double range = 0.0;
  cast_fan(origin, {&direction, 1}, max_range, ignore, {&range, 1});
  return range;
}

void World::cast_fan(Vec2 origin, std::span<const Vec2> directions, double max_range, BodyId ignore,
                     std::span<double> ranges) const {
  if (ranges.empty()) return;
  const RayFan fan{origin, directions, max_range, ignore, ranges};
  // A single ray finds its way through the grids sooner.
  if (directions.size() > 1 && impl_->are_few(fan) && impl_->cast_few({&fan, 1})) return;
  impl_->rays.cast_fan(origin, directions, max_range, ranges);
  const Bodies& bodies = impl_->bodies;
  const double farthest = std::min(*std::max_element(ranges.begin(), ranges.end()), kHorizon);
  const auto meet = [&](BodyId id) {
    const Vec2 centre = bodies.position(id);
    const double radius = bodies.radius_[id];
    const double reach = farthest + radius;
    if (id == ignore || norm_squared(centre - origin) >= reach * reach) return;
    if (bodies.convex_among(id, id)) {
      for (std::size_t i = 0; i < directions.size(); ++i) {
        ranges[i] = impl_->nearer_body_hit(id, origin, directions[i], ranges[i]);
      }
      return;
    }
    for (std::size_t i = 0; i < directions.size(); ++i) {
      ranges[i] = nearer_disc_hit(centre, radius, origin, directions[i], ranges[i]);
    }
  };
  // The least range wins in any order of visits.
  if (directions.size() == 1) {
    bodies.each_on_ray(origin, farthest * directions[0], meet);
  } else {
    bodies.each_on_way(origin, {}, farthest, meet);
  }
}

void World::cast_fans(std::span<const RayFan> fans) const {
  while (!fans.empty()) {
    const auto some = fans.first(std::min(fans.size(), kFansTogether));
    const auto end =
        std::ranges::find_if_not(some, [&](const RayFan& fan) { return impl_->are_few(fan); });
    // One that is not is cast alone.
    const auto count = static_cast<std::size_t>(std::max(end - some.begin(), std::ptrdiff_t{1}));
    if (end == some.begin() || !impl_->cast_few(some.first(count))) {
      for (const RayFan& fan : some.first(count)) {
        if (fan.origins.empty()) {
          cast_fan(fan.origin, fan.directions, fan.max_range, fan.ignore, fan.ranges);
        }
        for (std::size_t i = 0; i < fan.origins.size(); ++i) {
          fan.ranges[i] = cast_ray(fan.origins[i], fan.directions[i], fan.max_range, fan.ignore);
        }
      }
    }
    fans = fans.subspan(count);
  }
}

void World::cast_sweep(Vec2 origin, std::span<const Vec2> directions, double gap, double max_range,
                       BodyId ignore, std::span<double> ranges) const {
  // Sweeps need an order.
  if (gap == 0.0 || directions.size() <= Fan::kMost) {
    cast_fan(origin, directions, max_range, ignore, ranges);
    return;
  }
  for (std::size_t first = 0; first < directions.size(); first += Sweep::kMost) {
    const std::size_t count = std::min(directions.size() - first, Sweep::kMost);
    impl_->cast_around(origin, directions.subspan(first, count), gap, max_range, ignore,
                       ranges.subspan(first, count));
  }
}

void World::contacts(BodyId id, double reach, std::vector<Vec2>& out) const {
  const Bodies& bodies = impl_->bodies;
  const Vec2 p = bodies.position(id);
  const double limit = bodies.radius_[id] + reach + 2 * kContactGap;
  const std::size_t first = out.size();

  struct Touch {
    std::uint32_t index;
    Impl::Obstacle obstacle;
  };
  std::vector<Touch> touches;
  impl_->walls.each_near(p, limit, [&](std::uint32_t segment, double) {
    touches.push_back({segment, {0.0, true, segment, kNoBody}});
  });
  const std::size_t walls = touches.size();
  bodies.each_on_way(p, {}, limit, [&](BodyId other) {
    if (other == id || norm(bodies.position(other) - p) >= limit + bodies.radius_[other]) return;
    if (bodies.convex_among(other, other) && impl_->gap_to_point(other, p) >= limit) return;
    touches.push_back({other, {0.0, false, 0, other}});
  });
  // The grids do not promise an order.
  const auto by_index = [](const Touch& a, const Touch& b) { return a.index < b.index; };
  const auto split = touches.begin() + static_cast<std::ptrdiff_t>(walls);
  std::sort(touches.begin(), split, by_index);
  std::sort(split, touches.end(), by_index);
  for (const Touch& touch : touches) {
    const Vec2 direction = impl_->towards(touch.obstacle, id);
    if (direction != Vec2{}) add_once(direction, first, out);
  }
}

bool World::is_free(Vec2 centre, double radius, BodyId ignore) const {
  if (impl_->walls.distance(centre, radius + kContactGap) <= radius ||
      impl_->walls.inside_thick(centre)) {
    return false;
  }
  bool free = true;
  impl_->bodies.each_on_way(centre, {}, radius, [&](BodyId id) {
    const double touching = radius + impl_->bodies.radius_[id];
    if (impl_->bodies.convex_among(id, id) && impl_->gap_to_point(id, centre) > radius) return;
    if (id != ignore && norm_squared(impl_->bodies.position(id) - centre) <= touching * touching) {
      free = false;
    }
  });
  return free;
}

}  // namespace eyebridge::world
