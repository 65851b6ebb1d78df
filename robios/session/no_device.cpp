#include "no_device.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "eyebridge/files/load.hpp"
#include "session.hpp"

namespace eyebridge::robios {

tl::unexpected<Error> no_device(Session& session, std::string_view kind, int id,
                                const std::string& called) {
  return no_device(session.backend(), called.empty() ? fmt::format("{} {}", kind, id) : called,
                   files::robots_with(kind, id));
}

tl::unexpected<Error> no_device(hal::Backend& backend, const std::string& called,
                                const std::vector<std::string>& robots) {
  std::string text = "this robot has no " + called;
  // A real board lists its devices in its HDT file; a built-in robot does not help there.
  if (backend.environment() != nullptr && !robots.empty()) {
    text += fmt::format("; robots that have it: {}", fmt::join(robots, ", "));
  }
  return fail(Errc::NoDevice, text);
}

}  // namespace eyebridge::robios
