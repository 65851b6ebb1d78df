#pragma once

#include <memory>

#include "board/board_link.hpp"
#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal {

/// What drives the wheels: the board where it can, else the host over motors and encoders 1 and 2;
/// null where neither is possible. `link` and `clock`, the one of its line, must outlive it.
std::unique_ptr<DriveController> make_controller(BoardLink& link, Clock& clock,
                                                 const BoardDriveShape& shape);

}  // namespace eyebridge::hal
