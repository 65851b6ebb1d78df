#pragma once

#include <memory>
#include <string>

#include "eyebridge/bridges/byte_stream.hpp"

namespace eyebridge::bridges {

/// How a serial port is set up: always 8 data bits, no parity, 1 stop bit.
struct SerialSettings {
  std::string device;      ///< "/dev/ttyACM0" or a link to it.
  unsigned baud = 115200;  ///< Bits per second; USB boards (CDC-ACM) ignore it.
  bool handshake = false;  ///< RTS and CTS hold back the sender; else nothing does.
};

/// Opens `settings.device` for this process alone: locked against others, raw before a byte passes,
/// without hanging up (DTR stays) when it is closed, and emptied of what lay in its buffers.
///
/// Fails with Disconnected when the device is missing, forbidden, in use or gives an I/O error, and
/// Unsupported when it is no serial port or refuses the bit rate; the text says which, and what
/// to do. `clock` must outlive the stream.
Result<std::unique_ptr<ByteStream>> open_serial(const SerialSettings& settings, Clock& clock);

}  // namespace eyebridge::bridges
