#include "eyebridge/world/ray_caster.hpp"

#include "geometry.hpp"

namespace eyebridge::world {

struct RayCaster::Impl {
  std::vector<Segment> segments;
};

RayCaster::RayCaster(const WorldModel& model, RayMethod)
    : impl_(std::make_unique<Impl>(Impl{outlines_of(model.walls)})) {}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

double RayCaster::cast(Vec2 origin, Vec2 direction, double max_range) const {
  double range = max_range;
  for (const Segment& s : impl_->segments) range = nearer_hit(s, origin, direction, range);
  return range;
}

void RayCaster::cast_fan(Vec2 origin, std::span<const Vec2> directions, double max_range,
                         std::span<double> ranges) const {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    ranges[i] = cast(origin, directions[i], max_range);
  }
}

RayMethod RayCaster::method() const { return RayMethod::BruteForce; }

}  // namespace eyebridge::world
