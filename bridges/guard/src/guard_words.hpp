#pragma once

#include <cstdint>

#include "eyebridge/bridges/guard/stop_orders.hpp"

namespace eyebridge::bridges {

/// What a program tells its guard: one packet each, as long as its kind needs.
struct GuardWord {
  enum class Kind : std::uint8_t {
    Hold,     ///< All below; the line comes with it.
    LetGo,    ///< Answered by a byte.
    Turning,  ///< Wheels turn.
    Still,    ///< They do not.
  };
  Kind kind = Kind::Still;
  char device[256] = "";
  StopOrders orders;
};

}  // namespace eyebridge::bridges
