#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "can_report.hpp"
#include "eyebridge/bridges/memory.hpp"
#include "wait.hpp"

namespace eyebridge::bridges {

/// The bus itself: one lock for all nodes, which are few.
struct MemoryCan::Shared {
  Shared(Clock& its_clock, std::size_t its_capacity, bool its_fd)
      : clock(its_clock), capacity(std::max<std::size_t>(its_capacity, 1)), fd(its_fd) {}

  Clock& clock;
  const std::size_t capacity;
  const bool fd;
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Node*> nodes;
};

class MemoryCan::Node final : public CanBus {
 public:
  Node(std::shared_ptr<Shared> bus, std::string name)
      : bus_(std::move(bus)), name_(std::move(name)) {
    const std::lock_guard lock(bus_->mutex);
    bus_->nodes.push_back(this);
    if (bus_->nodes.size() > 1) {
      for (Node* node : bus_->nodes) node->had_company_ = true;
    }
    bus_->changed.notify_all();
  }
  ~Node() override {
    const std::lock_guard lock(bus_->mutex);
    std::erase(bus_->nodes, this);
    bus_->changed.notify_all();
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  Result<void> send(const CanFrame& frame, Time deadline) override {
    if (const char* wrong = why_not_sendable(frame)) {
      return fail(Errc::OutOfRange, name_ + ": " + wrong);
    }
    if (frame.fd && !bus_->fd) {
      return fail(Errc::Unsupported, name_ + ": not opened for CAN FD frames");
    }
    std::unique_lock lock(bus_->mutex);
    const bool in_time = wait_on(bus_->changed, lock, bus_->clock, deadline, [&] {
      return is_off() || is_deserted() || (bus_->nodes.size() > 1 && all_have_room());
    });
    if (is_off()) return tl::unexpected(bus_off_error(name_));
    if (is_deserted()) return deserted();
    if (!in_time) return fail(Errc::Timeout, name_ + ": the bus took no frame in time");
    for (Node* node : bus_->nodes) {
      if (node != this) node->queue_.push_back(frame);
    }
    ++statistics_.sent;
    bus_->changed.notify_all();
    return {};
  }

  Result<CanFrame> receive(Time deadline) override {
    std::unique_lock lock(bus_->mutex);
    while (true) {
      const bool in_time = wait_on(bus_->changed, lock, bus_->clock, deadline,
                                   [&] { return !queue_.empty() || is_deserted(); });
      if (queue_.empty()) {
        if (is_deserted()) return deserted();
        if (!in_time) return fail(Errc::Timeout, name_ + ": no frame came in time");
      }
      const CanFrame frame = queue_.front();
      queue_.pop_front();
      bus_->changed.notify_all();
      if (frame.error) {
        if (auto gone = note_report(frame, statistics_, name_)) return tl::unexpected(*gone);
      } else if (passes(frame)) {
        ++statistics_.received;
        return frame;
      }
    }
  }

  Result<void> set_filters(std::span<const CanFilter> filters) override {
    const std::lock_guard lock(bus_->mutex);
    filters_.assign(filters.begin(), filters.end());
    return {};
  }

  [[nodiscard]] CanStatistics statistics() const override {
    const std::lock_guard lock(bus_->mutex);
    return statistics_;
  }

  [[nodiscard]] std::string_view name() const override { return name_; }

  /// Under the bus's lock. Not subject to the capacity: the controller reports, nobody waits.
  void put_report(const CanFrame& frame) { queue_.push_back(frame); }

 private:
  [[nodiscard]] bool is_off() const { return statistics_.state == CanState::BusOff; }
  [[nodiscard]] bool is_deserted() const { return had_company_ && bus_->nodes.size() == 1; }
  [[nodiscard]] tl::unexpected<Error> deserted() const {
    return fail(Errc::Disconnected, name_ + ": all other nodes are gone");
  }
  [[nodiscard]] bool all_have_room() const {
    return std::ranges::all_of(bus_->nodes, [this](const Node* node) {
      return node == this || node->queue_.size() < bus_->capacity;
    });
  }
  [[nodiscard]] bool passes(const CanFrame& frame) const {
    return filters_.empty() ||
           std::ranges::any_of(filters_, [&](const CanFilter& f) { return f.passes(frame); });
  }

  const std::shared_ptr<Shared> bus_;
  const std::string name_;
  bool had_company_ = false;  // from here on under the bus's lock
  std::deque<CanFrame> queue_;
  std::vector<CanFilter> filters_;
  CanStatistics statistics_;
};

MemoryCan::MemoryCan(Clock& clock, std::size_t capacity, bool fd)
    : shared_(std::make_shared<Shared>(clock, capacity, fd)) {}
MemoryCan::~MemoryCan() = default;

std::unique_ptr<CanBus> MemoryCan::connect(std::string name) {
  return std::make_unique<Node>(shared_, std::move(name));
}

void MemoryCan::report(const CanFrame& error_frame) {
  CanFrame frame = error_frame;
  frame.error = true;
  const std::lock_guard lock(shared_->mutex);
  for (Node* node : shared_->nodes) node->put_report(frame);
  shared_->changed.notify_all();
}

}  // namespace eyebridge::bridges
