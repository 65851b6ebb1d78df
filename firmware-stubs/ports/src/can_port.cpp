#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "can_path.hpp"
#include "eyebridge/ports/can_hub.hpp"
#include "eyebridge/ports/lines.hpp"

namespace eyebridge::ports {
namespace {

constexpr int kPumpsBetweenTries = 20;

Opened open_interface(const std::string& interface, bool fd) {
  if (is_can_path(interface)) return connect_can_path(interface);
  UniqueFd socket(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  if (!socket.valid()) return {{}, errno};
  const can_err_mask_t errors = CAN_ERR_BUSOFF;
  ::setsockopt(socket.get(), SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &errors, sizeof errors);
  const int on = 1;
  if (fd && ::setsockopt(socket.get(), SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof on) != 0) {
    return {{}, errno};
  }
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  if (::ioctl(socket.get(), SIOCGIFINDEX, &request) != 0) return {{}, errno};
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = request.ifr_ifindex;
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    return {{}, errno};
  }
  if (::ioctl(socket.get(), SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) == 0) {
    return {{}, ENETDOWN};
  }
  return {std::move(socket), 0};
}

std::string explain(const std::string& interface, int code) {
  switch (code) {
    case EAFNOSUPPORT:
      return "this kernel has no CAN (errno 97): load the module can, or use --pty or --tcp";
    case EPROTONOSUPPORT:
      return "this kernel has CAN but no raw sockets (errno 93): load the module can_raw";
    case ENODEV:
      return "found no interface " + interface + " (errno 19), expected one that " +
             "'ip -br link show type can' or 'type vcan' lists";
    case ENETDOWN:
      return interface + " is down: sudo ip link set " + interface + " up";
    default:
      return "cannot open " + interface + ": " + std::generic_category().message(code);
  }
}

class CanPort : public Port {
 public:
  CanPort(FrameLine line, UniqueFd socket, bool fd, std::string interface, int node, CanPlace place)
      : line_(std::move(line)),
        socket_(std::move(socket)),
        fd_(fd),
        interface_(std::move(interface)),
        node_(node),
        place_(place) {}

  void pump() override {
    if (!socket_.valid() && !reopen()) return;
    receive_all();
    transmit_all();
  }
  [[nodiscard]] int descriptor() const override { return socket_.get(); }
  [[nodiscard]] bool wants_room() const override { return pending_.has_value(); }
  [[nodiscard]] bool connected() const override { return socket_.valid(); }
  [[nodiscard]] std::string address() const override {
    if (node_ == 0) return "can:" + interface_ + "?dbc=FILE.dbc&map=FILE.toml";
    std::string url = "can:" + interface_ + "?node=" + std::to_string(node_);
    if (place_.extended) url += "&ids=29";
    if (place_.offset > 0) url += "&offset=" + std::to_string(place_.offset);
    return url;
  }

 private:
  bool reopen() {
    if (interface_.empty() || --wait_ > 0) return false;
    wait_ = kPumpsBetweenTries;
    socket_ = open_interface(interface_, fd_).socket;
    return socket_.valid();
  }

  void lose() {
    socket_.reset();
    pending_.reset();
    wait_ = kPumpsBetweenTries;
    line_.lost();
  }

  void receive_all() {
    while (socket_.valid()) {
      canfd_frame wire{};
      const ssize_t size = ::read(socket_.get(), &wire, sizeof wire);
      if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
      if (size != CAN_MTU && size != CANFD_MTU) return lose();
      if ((wire.can_id & CAN_ERR_FLAG) != 0) {
        if ((wire.can_id & CAN_ERR_BUSOFF) != 0) line_.lost();
        continue;
      }
      eb_can_frame frame{};
      frame.extended = (wire.can_id & CAN_EFF_FLAG) != 0;
      frame.id = wire.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
      if (!place_.take(frame)) continue;
      frame.remote = (wire.can_id & CAN_RTR_FLAG) != 0;
      frame.fd = size == CANFD_MTU;
      frame.length = frame.remote ? 0 : std::min<std::uint8_t>(wire.len, frame.fd ? 64 : 8);
      std::memcpy(frame.data, wire.data, frame.length);
      line_.receive(frame);
    }
  }

  void transmit_all() {
    while (socket_.valid()) {
      eb_can_frame frame{};
      if (pending_) {
        frame = *pending_;
      } else if (!line_.transmit(frame)) {
        return;
      }
      pending_.reset();
      canfd_frame wire{};
      const eb_can_frame placed = place_.placed(frame);
      wire.can_id = placed.id | (placed.extended ? CAN_EFF_FLAG : 0U);
      wire.len = frame.length;
      std::memcpy(wire.data, frame.data, frame.length);
      const std::size_t size = frame.fd ? CANFD_MTU : CAN_MTU;
      if (::send(socket_.get(), &wire, size, MSG_NOSIGNAL) == static_cast<ssize_t>(size)) continue;
      if (errno != EAGAIN && errno != EINTR && errno != ENOBUFS) return lose();
      // The queue is full: frames are made when there is room, so that one alone gets old.
      pending_ = frame;
      return;
    }
  }

  FrameLine line_;
  UniqueFd socket_;
  bool fd_;
  std::string interface_;
  int node_;
  CanPlace place_;
  int wait_ = 0;
  std::optional<eb_can_frame> pending_;
};

}  // namespace

bool CanPlace::take(eb_can_frame& frame) const {
  if (offset == 0 && !extended) return true;
  if (frame.extended != extended || frame.id < offset) return false;
  frame.id -= offset;
  frame.extended = false;
  return frame.id <= CAN_SFF_MASK;
}

eb_can_frame CanPlace::placed(eb_can_frame frame) const {
  frame.id += offset;
  frame.extended = frame.extended || extended;
  return frame;
}

std::unique_ptr<Port> open_can(FrameLine line, const std::string& interface, bool fd, int node,
                               const SourceLocation& where, CanPlace place) {
  if (!is_can_path(interface) && (interface.empty() || interface.size() >= IFNAMSIZ)) {
    throw ConfigError(where, "found '" + interface +
                                 "', expected an interface of 1 to 15 characters, or the path of a "
                                 "bus's socket, with a '/'");
  }
  Opened opened = open_interface(interface, fd);
  if (!opened.socket.valid()) throw ConfigError(where, explain(interface, opened.code));
  return std::make_unique<CanPort>(std::move(line), std::move(opened.socket), fd, interface, node,
                                   place);
}

std::unique_ptr<Port> make_can_port(FrameLine line, UniqueFd socket) {
  return std::make_unique<CanPort>(std::move(line), std::move(socket), false, "", 0, CanPlace{});
}

}  // namespace eyebridge::ports
