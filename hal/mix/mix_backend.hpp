#pragma once

#include <memory>
#include <string>
#include <vector>

#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

/// Another backend, and the kinds of devices that are taken from it.
struct MixPart {
  std::vector<std::string> devices;  ///< As MixEntry::device.
  std::string url;                   ///< For messages.
  std::unique_ptr<Backend> backend;
};

/// `main` with some kinds of devices replaced by those of `parts`, whole kinds each. The clock, the
/// number, traces and the world's functions are those of `main`; stop() stops them all.
///
/// Where a backend with a world does not drive, its robot is moved as the one that does (by its
/// odometry on a board), from where it stood at first: so simulated sensors see what the real robot
/// would.
/// Virtual clocks of parts are moved along with the one of `main`. Throws ConfigError without a
/// place: a part has no such device, or is real while `main` lives in virtual time.
std::unique_ptr<Backend> make_mix(std::unique_ptr<Backend> main, std::vector<MixPart> parts);

}  // namespace eyebridge::hal
