#include "shared/open_slot.hpp"

#include "host/open_host.hpp"
#include "shared/shared_sim.hpp"
#include "sim/sim_backend.hpp"

namespace eyebridge::hal {

std::unique_ptr<Backend> open_slot(const WorldSlot& slot, const BackendContext& context) {
  auto& shared = dynamic_cast<SharedSim&>(*slot.world);
  auto robot =
      std::make_unique<SimBackend>(shared.world(), shared.clock_of(slot.robot), shared.view(),
                                   static_cast<robot::RobotIndex>(slot.robot),
                                   context.config.number("supply_voltage"), AtEnd::KeepDriving);
  return with_host_devices(std::move(robot), context, shared.air());
}

}  // namespace eyebridge::hal
