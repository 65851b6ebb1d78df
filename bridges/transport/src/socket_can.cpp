#include "eyebridge/bridges/socket_can.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <mutex>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <linux/can/raw.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "can_report.hpp"
#include "can_wire.hpp"
#include "wait.hpp"

namespace eyebridge::bridges {
namespace {

bool is_can_socket(int fd) {
  int domain = 0;
  socklen_t size = sizeof domain;
  return ::getsockopt(fd, SOL_SOCKET, SO_DOMAIN, &domain, &size) == 0 && domain == AF_CAN;
}

/// What recvmsg() brought: a frame, and how often the kernel had to drop one so far.
struct Received {
  ssize_t size = 0;
  canfd_frame frame{};
  std::optional<std::uint32_t> overflows;
};

Received receive_once(int fd) {
  Received got;
  iovec part{&got.frame, sizeof got.frame};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(std::uint32_t))];
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  got.size = ::recvmsg(fd, &message, MSG_DONTWAIT);
  if (got.size < 0) return got;
  if ((message.msg_flags & MSG_TRUNC) != 0) got.size = sizeof got.frame + 1;
  const cmsghdr* extra = CMSG_FIRSTHDR(&message);
  if (extra != nullptr && extra->cmsg_level == SOL_SOCKET && extra->cmsg_type == SO_RXQ_OVFL) {
    std::uint32_t count = 0;
    std::copy_n(CMSG_DATA(extra), sizeof count, reinterpret_cast<unsigned char*>(&count));
    got.overflows = count;
  }
  return got;
}

class SocketCan final : public CanBus {
 public:
  SocketCan(CanSocket socket, std::string name, Clock& clock, CanReopen reopen)
      : fd_(std::move(socket.socket)),
        fd_frames_(socket.fd),
        name_(std::move(name)),
        clock_(clock),
        reopen_(std::move(reopen)) {}

  Result<void> send(const CanFrame& frame, Time deadline) override {
    if (const char* wrong = why_not_sendable(frame)) {
      return fail(Errc::OutOfRange, name_ + ": " + wrong);
    }
    if (frame.fd && !fd_frames_) {
      return fail(Errc::Unsupported, name_ + ": not opened for CAN FD frames");
    }
    if (lost_) {
      // Waiting for a bus is for receive(): what should go out now is old by then.
      const std::unique_lock lock(reopening_, std::try_to_lock);
      if (!lock.owns_lock()) return fail(Errc::Disconnected, name_ + ": is not back yet");
      if (auto again = reopen(clock_.now()); !again) return again;
    }
    canfd_frame wire;
    const std::size_t size = to_wire(frame, wire);
    while (true) {
      if (is_off()) return tl::unexpected(bus_off_error(name_));
      if (::send(fd_.get(), &wire, size, MSG_NOSIGNAL | MSG_DONTWAIT) >= 0) break;
      if (errno == EINTR) continue;
      if (errno == EINVAL || errno == EMSGSIZE) {
        return fail(Errc::Unsupported,
                    name_ + ": the interface takes no such frame: " + errno_text(errno));
      }
      if (errno != EAGAIN && errno != ENOBUFS) return lost("sending", errno);
      if (!wait_for_room(errno == ENOBUFS, deadline)) {
        return fail(Errc::Timeout, name_ +
                                       ": the bus took no frame in time; expected another node "
                                       "that acknowledges, at the same bit rate");
      }
    }
    const std::lock_guard lock(mutex_);
    ++statistics_.sent;
    return {};
  }

  Result<CanFrame> receive(Time deadline) override {
    if (lost_) {
      const std::lock_guard lock(reopening_);
      if (auto again = reopen(deadline); !again) return tl::unexpected(std::move(again.error()));
    }
    while (true) {
      const Received got = receive_once(fd_.get());
      if (got.size > 0) {
        const auto frame = from_wire(got.frame, static_cast<std::size_t>(got.size));
        if (!frame) return fail(Errc::Corrupt, name_ + ": found what is no CAN frame");
        auto taken = take(*frame, got.overflows);
        if (!taken) return tl::unexpected(std::move(taken.error()));
        if (*taken) return *frame;
        continue;
      }
      if (got.size == 0) return lost("receiving", ENOTCONN);
      if (errno == EINTR) continue;
      if (errno != EAGAIN) return lost("receiving", errno);
      if (!wait_ready(fd_.get(), POLLIN, clock_, deadline)) {
        return fail(Errc::Timeout, name_ + ": no frame came in time");
      }
    }
  }

  Result<void> set_filters(std::span<const CanFilter> filters) override {
    if (filters.size() > CAN_RAW_FILTER_MAX) {
      return fail(Errc::OutOfRange, name_ + ": found " + std::to_string(filters.size()) +
                                        " filters, the kernel takes at most 512");
    }
    const std::lock_guard lock(mutex_);
    filters_.assign(filters.begin(), filters.end());
    return filter_in_kernel();
  }

  [[nodiscard]] CanStatistics statistics() const override {
    const std::lock_guard lock(mutex_);
    return statistics_;
  }

  [[nodiscard]] int descriptor() const override { return fd_.get(); }
  [[nodiscard]] std::string_view name() const override { return name_; }

 private:
  /// Counts a frame; true when it is for the caller.
  Result<bool> take(const CanFrame& frame, std::optional<std::uint32_t> overflows) {
    const std::lock_guard lock(mutex_);
    if (overflows) {
      statistics_.dropped +=
          *overflows - last_overflows_;  // the kernel's count wraps, as this does
      last_overflows_ = *overflows;
    }
    if (frame.error) {
      if (auto gone = note_report(frame, statistics_, name_)) return tl::unexpected(*gone);
      return false;
    }
    // A restart that nobody reported: whoever hears frames is on the bus.
    if (statistics_.state == CanState::BusOff) statistics_.state = CanState::Active;
    if (!filters_.empty() &&
        std::ranges::none_of(filters_, [&](const CanFilter& f) { return f.passes(frame); })) {
      return false;
    }
    ++statistics_.received;
    return true;
  }

  /// Under mutex_. A socket pair has no filters of its own: take() does it alone there.
  Result<void> filter_in_kernel() {
    if (!is_can_socket(fd_.get())) return {};
    std::vector<can_filter> kernel{{0, 0}};
    if (!filters_.empty()) kernel.clear();
    for (const CanFilter& filter : filters_) {
      kernel.push_back({filter.id | (filter.extended ? CAN_EFF_FLAG : 0U),
                        (filter.mask & CAN_EFF_MASK) | CAN_EFF_FLAG | CAN_RTR_FLAG});
    }
    if (::setsockopt(fd_.get(), SOL_CAN_RAW, CAN_RAW_FILTER, kernel.data(),
                     static_cast<socklen_t>(kernel.size() * sizeof(can_filter))) != 0) {
      return fail(Errc::Unsupported, name_ + ": cannot set filters: " + errno_text(errno));
    }
    return {};
  }

  bool wait_for_room(bool device_queue_full, Time deadline) {
    if (!device_queue_full) return wait_ready(fd_.get(), POLLOUT, clock_, deadline);
    // The socket itself is writable then, so poll() cannot tell when there is room again.
    constexpr Time kPause = std::chrono::milliseconds(1);
    const Time now = clock_.now();
    if (now >= deadline) return false;
    clock_.wait_until(std::min(deadline, now + kPause));
    return true;
  }

  bool is_off() const {
    const std::lock_guard lock(mutex_);
    return statistics_.state == CanState::BusOff;
  }

  tl::unexpected<Error> lost(const char* doing, int error) {
    lost_ = true;
    return fail(Errc::Disconnected, name_ + ": gone while " + doing + ": " + errno_text(error));
  }

  /// Under reopening_.
  Result<void> reopen(Time deadline) {
    if (!lost_) return {};
    if (!reopen_) return fail(Errc::Disconnected, name_ + ": is gone");
    Result<CanSocket> fresh = reopen_(deadline);
    if (!fresh) return tl::unexpected(std::move(fresh.error()));
    // In place: the other thread may be in a call with the old number.
    if (::dup3(fresh->socket.get(), fd_.get(), O_CLOEXEC) < 0) {
      return fail(Errc::Disconnected, name_ + ": cannot be opened again: " + errno_text(errno));
    }
    fd_frames_ = fresh->fd;
    const std::lock_guard lock(mutex_);
    ++statistics_.reconnects;
    statistics_.state = CanState::Active;
    last_overflows_ = 0;
    lost_ = false;
    return filter_in_kernel();
  }

  const UniqueFd fd_;
  std::atomic<bool> fd_frames_;
  const std::string name_;
  Clock& clock_;
  const CanReopen reopen_;
  std::atomic<bool> lost_ = false;
  std::mutex reopening_;
  mutable std::mutex mutex_;  // of everything below
  CanStatistics statistics_;
  std::vector<CanFilter> filters_;
  std::uint32_t last_overflows_ = 0;
};

}  // namespace

std::unique_ptr<CanBus> make_socket_can(CanSocket socket, std::string name, Clock& clock,
                                        CanReopen reopen) {
  return std::make_unique<SocketCan>(std::move(socket), std::move(name), clock, std::move(reopen));
}

}  // namespace eyebridge::bridges
