#pragma once

#include <string>

namespace eyebridge::hal {

/// What the description of a robot (its file, a board's HDT) says about one of its devices, beyond
/// what the device itself tells.
struct DeviceFacts {
  int id = 0;                    ///< As Backend's lookups take it.
  std::string name;              ///< "PSD_FRONT"; empty when it has none.
  int semantics = 0;             ///< Number of classic RoBIOS (negative); 0 when none is given.
  double ticks_per_metre = 0.0;  ///< Of an encoder; 0 when not known.

  friend bool operator==(const DeviceFacts&, const DeviceFacts&) = default;
};

}  // namespace eyebridge::hal
