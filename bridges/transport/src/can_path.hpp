#pragma once

#include <cstddef>
#include <string_view>

#include "eyebridge/bridges/socket_can.hpp"

namespace eyebridge::bridges {

/// Characters that the name of a Unix socket may have: sockaddr_un's 108, less the zero.
inline constexpr std::size_t kLongestCanPath = 107;

/// Whether `interface` names a Unix socket: interfaces of Linux have no '/' in their names.
bool is_can_path(std::string_view interface);

/// Connects to the bus behind that socket. Fails with Disconnected when nobody serves it.
Result<CanSocket> connect_can_path(const SocketCanSettings& settings);

}  // namespace eyebridge::bridges
