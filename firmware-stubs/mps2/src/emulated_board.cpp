#include "eyebridge/mps2/emulated_board.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <utility>

#include <sys/socket.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::mps2 {
namespace {

using namespace std::chrono_literals;

constexpr Time kPatience = 10s;
constexpr int kLook_ms = 100;
constexpr std::size_t kMostPending = 65536;

bool only_waits() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

/// Appends what there is to `bytes`; false when the other side is gone.
bool read_into(int fd, std::vector<std::uint8_t>& bytes) {
  std::array<std::uint8_t, 1024> buffer;
  for (;;) {
    const ssize_t got = ::recv(fd, buffer.data(), buffer.size(), 0);
    if (got == 0) return false;
    if (got < 0) return only_waits();
    bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + got);
  }
}

/// Sends as much of `bytes` as fits and removes it; false when the other side is gone.
bool write_from(int fd, std::vector<std::uint8_t>& bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0) return only_waits();
    bytes.erase(bytes.begin(), bytes.begin() + sent);
  }
  return true;
}

}  // namespace

EmulatedBoard::EmulatedBoard(const EmulatorSettings& settings, pins::BoardWorld& world,
                             robot::RobotIndex robot, const eb_config& config, ports::Now now)
    : now_(std::move(now)),
      command_(settings.command),
      emulator_(settings),
      plant_(world, robot, config),
      heard_(now_()) {
  wait_for_firmware(settings.elf);
}

void EmulatedBoard::wait_for_firmware(const std::string& elf) {
  while (plant_.periods() == 0) {
    const auto moved = pump();
    if (!moved && moved.error().code == Errc::Timeout) {
      throw ConfigError({elf}, plant_.starts() == 0
                                   ? "says nothing on the plant link, expected the firmware of the "
                                     "emulated board (eyebridge-mps2.elf)"
                                   : "does not take this robot's configuration");
    }
    if (!moved) throw ConfigError({elf}, moved.error().what);
    if (!plant_.refusal().empty()) throw ConfigError({elf}, plant_.refusal());
    std::array<pollfd, 2> lines = descriptors();
    ::poll(lines.data(), lines.size(), kLook_ms);
  }
}

ports::ByteLine EmulatedBoard::line() {
  return {[this](std::span<const std::uint8_t> bytes) { take_from_host(bytes); },
          [this](std::span<std::uint8_t> out) {
            const std::size_t count = std::min(out.size(), to_host_.size());
            std::copy_n(to_host_.begin(), count, out.begin());
            to_host_.erase(to_host_.begin(), to_host_.begin() + static_cast<std::ptrdiff_t>(count));
            return count;
          },
          [this] {
            plant_.host_lost();
            to_board_.clear();
            to_host_.clear();
          }};
}

void EmulatedBoard::take_from_host(std::span<const std::uint8_t> bytes) {
  // A host that never stops is not to fill our memory: what a board cannot take is lost.
  if (to_board_.size() + bytes.size() <= kMostPending) {
    to_board_.insert(to_board_.end(), bytes.begin(), bytes.end());
  }
  serve_host();  // at once: a request is not to wait for the next turn
}

bool EmulatedBoard::serve_plant() {
  std::vector<std::uint8_t> bytes;
  if (!read_into(emulator_.plant_line(), bytes)) return false;
  const auto reply = plant_.receive(bytes);
  to_plant_line_.insert(to_plant_line_.end(), reply.begin(), reply.end());
  return write_from(emulator_.plant_line(), to_plant_line_);
}

bool EmulatedBoard::serve_host() {
  const std::size_t before = to_host_.size();
  if (!read_into(emulator_.host_line(), to_host_)) return false;
  // While the firmware does not know that its host has changed, it talks to the one before, and the
  // new one's requests would be swept away with the old one's.
  if (!plant_.settled()) {
    to_host_.resize(before);
    return true;
  }
  if (to_host_.size() > kMostPending) to_host_.resize(kMostPending);  // nobody reads it
  return write_from(emulator_.host_line(), to_board_);
}

Result<void> EmulatedBoard::pump() {
  // The host's line first: what was said before the firmware knew of a loss is to be thrown away.
  if (!serve_host() || !serve_plant() || !serve_host()) return ended();
  if (plant_.periods() != seen_periods_) {
    seen_periods_ = plant_.periods();
    heard_ = now_();
  }
  if (now_() - heard_ > kPatience) {
    return fail(Errc::Timeout, "the emulated board's firmware is silent");
  }
  return {};
}

Result<void> EmulatedBoard::ended() {
  return fail(Errc::Disconnected,
              "the emulated board is gone: " + command_ + ' ' + emulator_.end());
}

std::array<pollfd, 2> EmulatedBoard::descriptors() const {
  const auto entry = [](int fd, bool pending) {
    return pollfd{fd, static_cast<short>(pending ? POLLIN | POLLOUT : POLLIN), 0};
  };
  return {entry(emulator_.host_line(), plant_.settled() && !to_board_.empty()),
          entry(emulator_.plant_line(), !to_plant_line_.empty())};
}

}  // namespace eyebridge::mps2
