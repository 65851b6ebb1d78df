#include "remote_robot/open_remote_robot.hpp"

#include <charconv>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>

#include "remote_robot/remote_robot.hpp"
#include "sim/open_sim.hpp"

namespace eyebridge::hal {
namespace {

/// The descriptor that `text` names when it is a socket; else nothing.
UniqueFd inherited(const std::string& text) {
  int descriptor = -1;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, descriptor);
  int type = 0;
  socklen_t size = sizeof type;
  const bool is_socket = error == std::errc() && stop == end && descriptor > 2 &&
                         getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) == 0;
  if (!is_socket) return {};
  // Programs that this one starts must not keep the line.
  fcntl(descriptor, F_SETFD, FD_CLOEXEC);
  return UniqueFd(descriptor);
}

}  // namespace

std::unique_ptr<Backend> open_remote_robot(const BackendUrl& url, const BackendContext& context) {
  const SourceLocation& where = context.config.value("hal").where;
  for (const auto& [key, value] : url.options) {
    if (key != "robot") {
      throw ConfigError(where, fmt::format("found '{}={}', expected robot=N", key, value));
    }
  }
  UniqueFd socket = inherited(url.rest);
  if (!socket.valid()) {
    throw ConfigError(where,
                      fmt::format("found '{}', expected a robot that this process was given: "
                                  "--robots starts programs with theirs",
                                  context.config.text("hal")));
  }
  const auto world = [config = context.config] {
    return std::make_shared<const world::WorldModel>(named_scenario(config).world);
  };
  try {
    return make_remote_robot(std::move(socket), world, context.config.number("factor"));
  } catch (const ConfigError& error) {
    throw ConfigError(where, error.text());
  }
}

}  // namespace eyebridge::hal
