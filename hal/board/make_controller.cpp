#include "board/make_controller.hpp"

#if __has_include("board/host_drive.hpp")
#include "board/host_controller.hpp"
#endif

namespace eyebridge::hal {

std::unique_ptr<DriveController> make_controller(BoardLink& link, Clock& clock,
                                                 const BoardDriveShape& shape) {
  if (auto controller = link.make_drive(shape)) return controller;
#if __has_include("board/host_drive.hpp")
  if (link.has_motor(1) && link.has_motor(2) && link.has_encoder(1) && link.has_encoder(2)) {
    return std::make_unique<HostController>(link, clock, shape);
  }
#else
  (void)clock;
#endif
  return nullptr;
}

}  // namespace eyebridge::hal
