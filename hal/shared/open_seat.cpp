#include "shared/open_seat.hpp"

#include "host/open_host.hpp"
#include "shared/shared_sim.hpp"
#include "sim/sim_backend.hpp"

namespace eyebridge::hal {

std::unique_ptr<Backend> open_seat(const Seat& seat, const BackendContext& context) {
  auto& shared = dynamic_cast<SharedSim&>(*seat.world);
  auto robot =
      std::make_unique<SimBackend>(shared.world(), shared.clock_of(seat.robot), shared.view(),
                                   static_cast<robot::RobotIndex>(seat.robot),
                                   context.config.number("supply_voltage"), AtEnd::KeepDriving);
  return with_host_devices(std::move(robot), context, shared.air());
}

}  // namespace eyebridge::hal
