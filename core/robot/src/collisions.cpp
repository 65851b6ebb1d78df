#include <algorithm>

#include "simulation_impl.hpp"

namespace eyebridge::robot {

std::optional<RobotIndex> Simulation::Impl::robot_of(world::BodyId body) const {
  const auto found = std::ranges::lower_bound(cruises, body, {}, &Cruise::body);
  if (found == cruises.end() || found->body != body) return std::nullopt;
  return static_cast<RobotIndex>(found - cruises.begin());
}

void Simulation::Impl::report_collisions() {
  for (const world::Bump& bump : world.bumps()) {
    if (collisions.size() == 2 * kCollisionsKept) {
      const auto half = collisions.begin() + static_cast<std::ptrdiff_t>(kCollisionsKept);
      collisions.erase(collisions.begin(), half);
      collisions_dropped += kCollisionsKept;
    }
    const double time = static_cast<double>(steps) * settings.step;
    collisions.push_back({time, bump.body, robot_of(bump.body), bump.other, robot_of(bump.other),
                          bump.place, world.pose(bump.body), world.object_of(bump.body),
                          world.object_of(bump.other)});
    if (listener) listener(collisions.back());
  }
}

std::span<const CollisionEvent> Simulation::collisions() const { return impl_->collisions; }

std::uint64_t Simulation::collision_count() const {
  return impl_->collisions_dropped + impl_->collisions.size();
}

void Simulation::on_collision(std::function<void(const CollisionEvent&)> listener) {
  impl_->listener = std::move(listener);
}

}  // namespace eyebridge::robot
