#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"
#include "eyebridge/hal/serial_port.hpp"

namespace eyebridge::hal {

/// A serial port of this computer, or a pseudo-terminal.
class HostSerial final : public SerialPort {
 public:
  /// `device` as find_serial_device() takes it; `id` for messages. Opens nothing yet.
  HostSerial(int id, std::string device) : id_(id), device_(std::move(device)) {}

  Result<void> open(int baud, bool handshake) override;
  Result<void> send(std::span<const std::uint8_t> bytes) override;
  Result<std::size_t> receive(std::span<std::uint8_t> buffer, Time patience) override;
  Result<std::size_t> pending() override;
  Result<void> flush() override;
  Result<void> close() override;

 private:
  Result<void> check_open() const;    // under either lock
  Result<void> fetch(Time patience);  // under reading_

  const int id_;
  const std::string device_;
  bridges::MonotonicClock clock_;
  // One thread may send while another waits for what comes. Who opens or closes takes both.
  std::mutex reading_;
  std::mutex writing_;
  std::unique_ptr<bridges::ByteStream> stream_;
  std::vector<std::uint8_t> arrived_;
};

}  // namespace eyebridge::hal
