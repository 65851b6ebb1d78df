#include <cerrno>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "eyebridge/ports/lines.hpp"
#include "fd_bytes.hpp"

namespace eyebridge::ports {
namespace {

constexpr std::string_view kBusy = "busy: another host has this board\r\n";

std::string error_text() { return std::generic_category().message(errno); }

sockaddr_in parse_address(const std::string& text, const SourceLocation& where) {
  const auto refuse = [&] {
    throw ConfigError(where, "found '" + text + "', expected a port 0 to 65535 or ADDRESS:PORT");
  };
  const std::size_t colon = text.rfind(':');
  const std::string host = colon == std::string::npos ? "127.0.0.1" : text.substr(0, colon);
  const std::string_view digits =
      std::string_view(text).substr(colon == std::string::npos ? 0 : colon + 1);
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size() ||
      ::inet_pton(AF_INET, host.c_str(), &address.sin_addr) != 1) {
    refuse();
  }
  address.sin_port = htons(port);
  return address;
}

class TcpPort : public Port {
 public:
  TcpPort(ByteLine line, UniqueFd listener, std::string address)
      : bytes_(std::move(line)), listener_(std::move(listener)), address_(std::move(address)) {}

  void pump() override {
    accept_hosts();
    if (host_.valid() && !bytes_.pump(host_.get())) {
      host_.reset();
      accept_hosts();
    }
  }
  // While a host is there, others wait for the next pump() to be sent away.
  [[nodiscard]] int descriptor() const override {
    return host_.valid() ? host_.get() : listener_.get();
  }
  [[nodiscard]] bool wants_room() const override { return bytes_.wants_room(); }
  [[nodiscard]] bool connected() const override { return host_.valid(); }
  [[nodiscard]] std::string address() const override { return "tcp:" + address_; }

 private:
  void accept_hosts() {
    for (;;) {
      UniqueFd host(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
      if (!host.valid()) return;
      if (host_.valid()) {
        [[maybe_unused]] const auto sent =
            ::send(host.get(), kBusy.data(), kBusy.size(), MSG_NOSIGNAL);
        continue;
      }
      const int on = 1;
      ::setsockopt(host.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
      host_ = std::move(host);
    }
  }

  FdBytes bytes_;
  UniqueFd listener_;
  UniqueFd host_;
  std::string address_;
};

std::string bound_address(int fd) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  char host[INET_ADDRSTRLEN] = {};
  if (::getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
      ::inet_ntop(AF_INET, &address.sin_addr, host, sizeof host) == nullptr) {
    return {};
  }
  // Whoever listens everywhere is reached here, too.
  const bool everywhere = address.sin_addr.s_addr == htonl(INADDR_ANY);
  return (everywhere ? "127.0.0.1" : std::string(host)) + ':' +
         std::to_string(ntohs(address.sin_port));
}

}  // namespace

std::unique_ptr<Port> open_tcp(ByteLine line, const std::string& address,
                               const SourceLocation& where) {
  const sockaddr_in place = parse_address(address, where);
  UniqueFd listener(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  const int on = 1;
  if (!listener.valid() ||
      ::setsockopt(listener.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
      ::bind(listener.get(), reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 ||
      ::listen(listener.get(), 4) != 0) {
    throw ConfigError(where, "cannot listen on " + address + ": " + error_text());
  }
  std::string bound = bound_address(listener.get());
  return std::make_unique<TcpPort>(std::move(line), std::move(listener), std::move(bound));
}

}  // namespace eyebridge::ports
