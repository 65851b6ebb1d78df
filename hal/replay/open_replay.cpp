#include "replay/open_replay.hpp"

#include <fmt/format.h>

#include "calls/absent_robot.hpp"
#include "replay/replayed_calls.hpp"

namespace eyebridge::hal {
namespace {

bool wants_strict(const BackendUrl& url, const SourceLocation& where) {
  bool strict = true;
  for (const auto& [key, value] : url.options) {
    if (key != "mode" || (value != "strict" && value != "lenient")) {
      throw ConfigError(
          where, fmt::format("found '{}={}', expected mode=strict or mode=lenient", key, value));
    }
    strict = value == "strict";
  }
  return strict;
}

}  // namespace

std::unique_ptr<Backend> open_replay(const BackendUrl& url, const BackendContext& context) {
  const SourceLocation& where = context.config.value("hal").where;
  const bool strict = wants_strict(url, where);
  if (url.rest.empty()) throw ConfigError(where, "found no file, expected replay:FILE.ebrec");
  Recording recording = read_recording(url.rest);
  if (recording.devices.empty() && recording.exchanges.empty()) {
    throw ConfigError({url.rest},
                      "found a recording without a robot, expected one of --record; its "
                      "frames are a camera: --camera frames:" +
                          url.rest);
  }
  const auto make_interceptor = [&](Backend& robot) -> std::unique_ptr<CallInterceptor> {
    if (!strict) return std::make_unique<LenientReplay>(recording.exchanges, robot.clock());
    return std::make_unique<StrictReplay>(std::move(recording.exchanges), robot.clock(),
                                          context.log);
  };
  try {
    return with_interceptor(make_absent_robot(recording.devices), make_interceptor);
  } catch (const ConfigError& error) {
    throw ConfigError({url.rest}, error.text());
  }
}

}  // namespace eyebridge::hal
