#include "host/host_serial.hpp"

#include <algorithm>

#include "eyebridge/bridges/serial.hpp"
#include "host/serial_devices.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;

constexpr int kSlowest = 50;  // bits per second, as RoBIOS allows
constexpr int kFastest = 4'000'000;
constexpr Time kLongestSend = 1s;
constexpr std::size_t kMostWaiting = 65536;  // then the kernel has to hold them back

}  // namespace

Result<void> HostSerial::open(int baud, bool handshake) {
  if (baud < kSlowest || baud > kFastest) {
    return fail(Errc::OutOfRange, "serial " + std::to_string(id_) + ": got " +
                                      std::to_string(baud) +
                                      " bits per second, expected 50 … "
                                      "4000000");
  }
  const std::scoped_lock lock(reading_, writing_);
  stream_.reset();
  arrived_.clear();
  bridges::SerialSettings settings;
  settings.device = find_serial_device(device_, kSerialById);
  if (settings.device.empty()) {
    return fail(Errc::Disconnected, "serial " + std::to_string(id_) + ": no device in " +
                                        kSerialById + " is called '" + device_ +
                                        "'; expected one that is plugged in, or a path");
  }
  settings.baud = static_cast<unsigned>(baud);
  settings.handshake = handshake;
  auto opened = bridges::open_serial(settings, clock_);
  if (!opened) return tl::unexpected(opened.error());
  stream_ = std::move(*opened);
  return {};
}

Result<void> HostSerial::check_open() const {
  if (stream_) return {};
  return fail(Errc::Unsupported, "serial " + std::to_string(id_) +
                                     ": it is not open; expected "
                                     "SERInit() before");
}

Result<void> HostSerial::send(std::span<const std::uint8_t> bytes) {
  const std::lock_guard lock(writing_);
  return check_open().and_then(
      [&] { return stream_->write_all(bytes, clock_.now() + kLongestSend); });
}

Result<void> HostSerial::fetch(Time patience) {
  std::array<std::uint8_t, 4096> chunk;
  if (arrived_.size() >= kMostWaiting) return {};
  const Time deadline = arrived_.empty() ? clock_.now() + patience : Time{0};
  const auto count =
      patience > Time{0} ? stream_->read_some(chunk, deadline) : stream_->read_now(chunk);
  if (count) {
    arrived_.insert(arrived_.end(), chunk.begin(),
                    chunk.begin() + static_cast<std::ptrdiff_t>(*count));
    return {};
  }
  // What came before the end is handed over first.
  if (count.error().code == Errc::Timeout || !arrived_.empty()) return {};
  return tl::unexpected(count.error());
}

Result<std::size_t> HostSerial::receive(std::span<std::uint8_t> buffer, Time patience) {
  const std::lock_guard lock(reading_);
  return check_open().and_then([&] { return fetch(patience); }).map([&] {
    const std::size_t count = std::min(buffer.size(), arrived_.size());
    const auto end = arrived_.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(arrived_.begin(), end, buffer.begin());
    arrived_.erase(arrived_.begin(), end);
    return count;
  });
}

Result<std::size_t> HostSerial::pending() {
  const std::lock_guard lock(reading_);
  return check_open().and_then([&] { return fetch(Time{0}); }).map([&] { return arrived_.size(); });
}

Result<void> HostSerial::flush() {
  const std::lock_guard lock(reading_);
  return check_open().and_then([&]() -> Result<void> {
    std::array<std::uint8_t, 4096> chunk;
    arrived_.clear();
    for (;;) {
      const auto count = stream_->read_now(chunk);
      if (!count) return tl::unexpected(count.error());
      if (*count == 0) return {};
    }
  });
}

Result<void> HostSerial::close() {
  const std::scoped_lock lock(reading_, writing_);
  stream_.reset();
  arrived_.clear();
  return {};
}

}  // namespace eyebridge::hal
