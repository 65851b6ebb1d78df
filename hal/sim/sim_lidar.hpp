#pragma once

#include "eyebridge/hal/lidar.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// The scanning range sensor of a simulated robot.
///
/// A beam tilted down ends at the floor. Walls count as tall enough for a beam tilted up.
class SimLidar final : public Lidar, private SimDevice {
 public:
  static constexpr int kFewestPoints = 1;
  static constexpr int kMostPoints = 36000;

  SimLidar(SimWorld& world, robot::RobotIndex robot);

  Result<void> configure(double field_of_view, double tilt, int points) override;
  [[nodiscard]] LidarShape shape() const override;
  Result<void> read(std::span<double> ranges) override;
  [[nodiscard]] double max_range() const override { return max_range_; }

 private:
  LidarShape shape_;  ///< Guarded by the world's lock.
  double max_range_ = 0.0;
};

}  // namespace eyebridge::hal
