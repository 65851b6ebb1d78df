#include "eyebridge/ports/can_hub.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <linux/can.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "can_path.hpp"

namespace eyebridge::ports {
namespace {

namespace fs = std::filesystem;

constexpr int kBacklog = 32;
constexpr int kSendBuffer = 1 << 20;  // bytes, as much as the bridge asks of a CAN interface

class CanHub final : public Port {
 public:
  CanHub(UniqueFd listener, UniqueFd poller, std::string path)
      : listener_(std::move(listener)), poller_(std::move(poller)), path_(std::move(path)) {
    watch(listener_.get());
  }
  ~CanHub() override {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  CanHub(const CanHub&) = delete;
  CanHub& operator=(const CanHub&) = delete;

  void pump() override {
    accept_nodes();
    for (UniqueFd& node : nodes_) pass_on(node);
    std::erase_if(nodes_, [](const UniqueFd& node) { return !node.valid(); });
  }
  [[nodiscard]] int descriptor() const override { return poller_.get(); }
  [[nodiscard]] bool connected() const override { return !nodes_.empty(); }
  [[nodiscard]] std::string address() const override { return "can:" + path_; }

 private:
  void watch(int fd) {
    epoll_event event{};
    event.events = EPOLLIN;
    ::epoll_ctl(poller_.get(), EPOLL_CTL_ADD, fd, &event);
  }

  void accept_nodes() {
    for (;;) {
      UniqueFd node(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
      if (!node.valid()) return;
      ::setsockopt(node.get(), SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof kSendBuffer);
      watch(node.get());
      nodes_.push_back(std::move(node));
    }
  }

  /// Gives what `from` sent to all others; closes it when it is gone.
  void pass_on(UniqueFd& from) {
    canfd_frame frame{};
    for (;;) {
      const ssize_t size = ::recv(from.get(), &frame, sizeof frame, MSG_TRUNC);
      // Reset: it did not read all that was for it; what it has sent is still there.
      if (size < 0 && (errno == EINTR || errno == ECONNRESET)) continue;
      if (size < 0 && errno == EAGAIN) return;
      if (size <= 0) {
        from.reset();
        return;
      }
      // What is no frame is nobody's; a real bus could not even carry it.
      if (size != CAN_MTU && size != CANFD_MTU) continue;
      for (const UniqueFd& to : nodes_) {
        if (&to == &from || !to.valid()) continue;
        // Who does not listen misses frames, as on a real bus; who is gone is noticed above.
        [[maybe_unused]] const auto sent =
            ::send(to.get(), &frame, static_cast<std::size_t>(size), MSG_NOSIGNAL);
      }
    }
  }

  UniqueFd listener_;
  UniqueFd poller_;
  std::string path_;
  std::vector<UniqueFd> nodes_;
};

[[noreturn]] void refuse(const SourceLocation& where, const std::string& path, int code) {
  throw ConfigError(where,
                    "cannot serve a bus at " + path + ": " + std::generic_category().message(code));
}

}  // namespace

std::unique_ptr<Port> open_can_hub(const std::string& path, const SourceLocation& where) {
  const auto address = can_path_address(path);
  if (!address) {
    throw ConfigError(where, "found a path of " + std::to_string(path.size()) +
                                 " characters for a bus, expected at most " +
                                 std::to_string(sizeof address->sun_path - 1));
  }
  if (connect_can_path(path).socket.valid()) return nullptr;
  // A name that nobody answers at is what a killed process left.
  std::error_code ignored;
  if (fs::is_socket(path, ignored)) fs::remove(path, ignored);

  UniqueFd listener(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  UniqueFd poller(::epoll_create1(EPOLL_CLOEXEC));
  if (!listener.valid() || !poller.valid() ||
      ::bind(listener.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0 ||
      ::listen(listener.get(), kBacklog) != 0) {
    refuse(where, path, errno);
  }
  return std::make_unique<CanHub>(std::move(listener), std::move(poller), path);
}

}  // namespace eyebridge::ports
