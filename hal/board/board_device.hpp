#pragma once

#include <cmath>

#include "board/board_link.hpp"

namespace eyebridge::hal {

/// What every device of a board knows.
class BoardDevice {
 public:
  BoardDevice(BoardLink& link, int id) : link_(link), id_(id) {}

 protected:
  /// Success when `good`; else what `device` was asked for, as an error.
  static Result<void> require(bool good, const char* device, double value, const char* expected);

  BoardLink& link_;
  const int id_;
};

}  // namespace eyebridge::hal
