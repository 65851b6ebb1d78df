#pragma once

#include <map>
#include <memory>

#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

/// What the computer that a program runs on adds to its robot; each may be missing.
struct HostDevices {
  std::map<int, std::unique_ptr<SerialPort>> serial_ports;
  std::unique_ptr<Sound> sound;
  std::unique_ptr<Radio> radio;
};

/// `inner` with `devices`; what it has itself comes first.
std::unique_ptr<Backend> with_host(std::unique_ptr<Backend> inner, HostDevices devices);

}  // namespace eyebridge::hal
