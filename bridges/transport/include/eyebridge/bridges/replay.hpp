#pragma once

#include <memory>
#include <string>
#include <vector>

#include "eyebridge/bridges/trace.hpp"

namespace eyebridge::bridges {

// The other side of a line, played from a trace. Time does not matter, order does: what was
// received comes as soon as everything that was sent before it has been sent again. While it has
// not, reading waits until its deadline; behind the end of the trace it is Disconnected.

/// What becomes of something sent that the trace does not have at this place.
enum class ReplayMode {
  Strict,   ///< Corrupt, naming the line's place in the trace and both contents.
  Lenient,  ///< Nothing: it is ignored, and what was received comes without waiting.
};

/// A stream from `records`; how they were cut into chunks does not matter. `clock` must outlive it.
std::unique_ptr<ByteStream> make_replay_stream(std::vector<ByteRecord> records, std::string name,
                                               ReplayMode mode, Clock& clock);

/// A bus from `records`. Those of unknown direction count as received, error frames as reports of
/// the controller. `clock` must outlive it.
std::unique_ptr<CanBus> make_replay_bus(std::vector<CanRecord> records, std::string name,
                                        ReplayMode mode, Clock& clock);

}  // namespace eyebridge::bridges
