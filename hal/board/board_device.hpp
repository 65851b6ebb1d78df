#pragma once

#include "board/board_link.hpp"

namespace eyebridge::hal {

/// What every device of a board knows.
class BoardDevice {
 public:
  BoardDevice(BoardLink& link, int id) : link_(link), id_(id) {}

 protected:
  BoardLink& link_;
  const int id_;
};

}  // namespace eyebridge::hal
