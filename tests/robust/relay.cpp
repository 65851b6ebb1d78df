#include "relay.hpp"

#include <array>
#include <stdexcept>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include "eyebridge/bridges/fd_stream.hpp"
#include "eyebridge/bridges/tcp.hpp"

namespace eyebridge::testing {
namespace {

using namespace std::chrono_literals;
using bridges::ByteStream;

// The list of commands is the most of what is said at first: some 600 bytes.
constexpr std::size_t kSound = 2000;

/// Carries what is there from one to the other, and counts it; false when either is gone.
bool carry(ByteStream& from, ByteStream& to, Clock& clock, std::size_t& carried) {
  constexpr Time kRelayPatience = 200us;
  std::array<std::uint8_t, 512> buffer{};
  const auto count = from.read_some(buffer, clock.now() + kRelayPatience);
  if (!count) return count.error().code == Errc::Timeout;
  carried += *count;
  return to.write_all(std::span(buffer).first(*count), clock.now() + 1s).has_value();
}

}  // namespace

Relay::Relay(const std::string& board, const bridges::FaultPlan& plan)
    : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)), plan_(plan) {
  bridges::TcpSettings settings;
  settings.host = board.substr(0, board.rfind(':'));
  settings.port = static_cast<std::uint16_t>(std::stoi(board.substr(board.rfind(':') + 1)));
  auto connected = bridges::open_tcp(settings, clock_);
  if (!connected) throw std::runtime_error(connected.error().what);
  board_ = std::move(*connected);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::bind(listener_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 ||
      ::listen(listener_.get(), 1) != 0) {
    throw std::runtime_error("cannot listen");
  }
  thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
}

Relay::~Relay() = default;

std::string Relay::hal() const {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  ::getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size);
  return "tcp:127.0.0.1:" + std::to_string(ntohs(address.sin_port));
}

bridges::FaultCounts Relay::counts() const {
  return connected_ ? damaged_->counts() : bridges::FaultCounts{};
}

void Relay::serve(const std::stop_token& stop) {
  pollfd ready{listener_.get(), POLLIN, 0};
  while (::poll(&ready, 1, 20) == 0) {
    if (stop.stop_requested()) return;
  }
  UniqueFd fd(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
  const int on = 1;
  ::setsockopt(fd.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  auto program = bridges::make_fd_stream(std::move(fd), "program", clock_);
  sound_ = program.get();
  damaged_ = std::make_unique<bridges::FaultyStream>(std::move(program), plan_, clock_);
  connected_ = true;
  while (!stop.stop_requested()) {
    ByteStream& host = carried_ > kSound ? static_cast<ByteStream&>(*damaged_) : *sound_;
    // An exchange is one direction at a time, so one thread that looks at both in turn will do.
    if (!carry(host, *board_, clock_, carried_) || !carry(*board_, host, clock_, carried_)) return;
  }
}

}  // namespace eyebridge::testing
