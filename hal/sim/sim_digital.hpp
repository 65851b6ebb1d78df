#pragma once

#include <array>

#include "eyebridge/hal/digital_lines.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// The digital lines of a simulated robot: its bumpers and then its proximity switches drive lines
/// 1, 2 …, as on our boards (firmware-stubs/pins); nothing is connected to the others, and a
/// floating one reads 0.
class SimDigital final : public DigitalLines, private SimDevice {
 public:
  SimDigital(SimWorld& world, robot::RobotIndex robot);

  Result<void> setup(int line, LineMode mode) override;
  Result<bool> read(int line) override;
  Result<std::uint16_t> read_all() override;
  Result<void> write(int line, bool high) override;

 private:
  struct Line {
    LineMode mode = LineMode::PullUp;
    bool driven = false;  ///< What an output drives.
  };
  [[nodiscard]] bool level(robot::Simulation& simulation, std::size_t index) const;

  std::array<Line, kCount> lines_;  ///< Guarded by the world's lock.
};

}  // namespace eyebridge::hal
