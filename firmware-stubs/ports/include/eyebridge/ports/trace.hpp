#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/ports/port.hpp"

namespace eyebridge::ports {

/// Where lines of a trace go, without line end.
using TraceSink = std::function<void(std::string_view line)>;
using Now = std::function<Time()>;

/// `line`, telling `sink` what passes, in the form that the bridge's traces have: microseconds, '<'
/// for what the board received or '>' for what it sent, hex digits.
ByteLine traced(const ByteLine& line, const TraceSink& sink, const Now& now);
/// The same for frames, as `candump -L` has them: (seconds) name id#data, R or T.
FrameLine traced(const FrameLine& line, const std::string& name, const TraceSink& sink,
                 const Now& now);

}  // namespace eyebridge::ports
