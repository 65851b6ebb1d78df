#pragma once

#include <memory>

#include "shared_simulation.hpp"

namespace eyebridge::python {

/// One robot of a simulation, as Python holds it: keeps the simulation alive.
struct RobotHandle {
  std::shared_ptr<SharedSimulation> simulation;
  robot::RobotIndex index = 0;
};

}  // namespace eyebridge::python
