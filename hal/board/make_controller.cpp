#include "board/make_controller.hpp"

#include "board/host_controller.hpp"

namespace eyebridge::hal {

std::unique_ptr<DriveController> make_controller(BoardLink& link, Clock& clock,
                                                 const BoardDriveShape& shape) {
  if (auto controller = link.make_drive(shape)) return controller;
  if (link.has_motor(1) && link.has_motor(2) && link.has_speed_control() && link.has_encoder(1) &&
      link.has_encoder(2)) {
    return std::make_unique<HostController>(link, clock, shape);
  }
  return nullptr;
}

}  // namespace eyebridge::hal
