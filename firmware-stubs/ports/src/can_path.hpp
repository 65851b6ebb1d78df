#pragma once

#include <optional>
#include <string>

#include <sys/un.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::ports {

/// An open socket, or errno.
struct Opened {
  UniqueFd socket;
  int code = 0;
};

/// None when `path` is too long for a socket.
std::optional<sockaddr_un> can_path_address(const std::string& path);

/// Connects to the bus at `path`.
Opened connect_can_path(const std::string& path);

}  // namespace eyebridge::ports
