#pragma once

#include <memory>
#include <span>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::world {

/// How a RayCaster answers. All give the same ranges; they differ in speed.
enum class RayMethod {
  Auto,        ///< EdgeBits for grid mazes, else Grid.
  BruteForce,  ///< Every wall for every ray: the reference.
  Grid,        ///< Uniform grid, cells walked along the rays; rays of a fan in one register.
  EdgeBits,    ///< Walks the cells of a maze; only where every wall is a maze edge.
};

/// Ranges from points to the nearest wall. Immutable after construction; any thread.
class RayCaster {
 public:
  /// Builds the structure over `model`'s walls (outlines of thick ones included).
  /// Asking for a method the world cannot do throws std::invalid_argument.
  explicit RayCaster(const WorldModel& model, RayMethod method = RayMethod::Auto);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// Range in metres from `origin` along the unit vector `direction` to the nearest wall, or
  /// `max_range` when there is none nearer. Origins outside the floor are fine.
  [[nodiscard]] double cast(Vec2 origin, Vec2 direction, double max_range) const;

  /// cast() for each of `directions`; `ranges` has the same size.
  void cast_fan(Vec2 origin, std::span<const Vec2> directions, double max_range,
                std::span<double> ranges) const;

  /// The method in use: never Auto.
  [[nodiscard]] RayMethod method() const;

  struct Impl;

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::world
