#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "eyebridge/bridges/byte_stream.hpp"

namespace eyebridge::bridges {

/// Whom to call, and how long to try.
struct TcpSettings {
  std::string host;  ///< Name, IPv4 or IPv6 address without brackets.
  std::uint16_t port = 0;
  std::chrono::milliseconds connect_timeout{3000};  ///< Wall time, for all addresses together. A
                                                    ///< name server that is silent may take longer.
};

/// Connects to `settings.host`, with TCP_NODELAY. Fails with Timeout, or Disconnected for an
/// unknown host or a refused connection. `clock` must outlive the stream.
Result<std::unique_ptr<ByteStream>> open_tcp(const TcpSettings& settings, Clock& clock);

}  // namespace eyebridge::bridges
