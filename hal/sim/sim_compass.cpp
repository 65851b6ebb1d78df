#include "sim/sim_compass.hpp"

namespace eyebridge::hal {

Result<double> SimCompass::read() {
  return world_.sensed([&](auto& sim) { return sim.read_compass(robot_); });
}

}  // namespace eyebridge::hal
