#pragma once

#include "eyebridge/hal/world_control.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// The hand of God over a simulated world. Unknown ids and poses that are not finite are
/// OutOfRange.
class SimWorldControl final : public WorldControl, private SimDevice {
 public:
  using SimDevice::SimDevice;

  [[nodiscard]] int robot_count() const override;
  [[nodiscard]] int object_count() const override;
  [[nodiscard]] Result<Pose> robot_pose(int id) const override;
  Result<void> set_robot_pose(int id, const Pose& pose) override;
  [[nodiscard]] Result<double> robot_altitude(int id) const override;
  Result<void> set_robot_altitude(int id, double altitude) override;
  [[nodiscard]] Result<Pose> object_pose(int id) const override;
  Result<void> set_object_pose(int id, const Pose& pose) override;
  Result<int> add_object(const world::ObjectSpec& object) override;
  Result<void> change_object(int id, const std::string& lines) override;
  Result<void> remove_object(int id) override;
  Result<void> set_object_velocity(int id, Vec2 velocity) override;
  Result<void> set_object_fixed(int id, bool fixed) override;
  Result<void> set_errors(int id, const std::string& rules, double share) override;

 private:
  [[nodiscard]] Result<robot::RobotIndex> robot_index(int id) const;
};

}  // namespace eyebridge::hal
