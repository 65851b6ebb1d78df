#pragma once

#include <string>
#include <vector>

#include "machine.hpp"

namespace eyebridge::apps {

/// A CAN interface of this machine.
struct CanInterface {
  std::string name;
  bool up = false;
};

/// What the kernel says to whoever wants CAN: error numbers of opening sockets, 0 where it works.
struct CanState {
  int raw_error = 0;
  int isotp_error = 0;
  std::vector<CanInterface> interfaces;
};

/// Asks the kernel; changes nothing.
CanState look_at_can();

/// One finding each for CAN itself, ISO-TP and the interfaces, with what to do; what cannot be
/// there without something above it is left out.
std::vector<Finding> judge_can(const CanState& state);

}  // namespace eyebridge::apps
