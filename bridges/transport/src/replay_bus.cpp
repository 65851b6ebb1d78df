#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "can_report.hpp"
#include "eyebridge/bridges/replay.hpp"
#include "replay_cursors.hpp"
#include "wait.hpp"

namespace eyebridge::bridges {
namespace {

class ReplayBus final : public CanBus {
 public:
  ReplayBus(std::vector<CanRecord> records, std::string name, ReplayMode mode, Clock& clock)
      : cursors_(std::move(records), mode), name_(std::move(name)), clock_(clock) {}

  Result<void> send(const CanFrame& frame, Time) override {
    if (const char* wrong = why_not_sendable(frame)) {
      return fail(Errc::OutOfRange, name_ + ": " + wrong);
    }
    const std::lock_guard lock(mutex_);
    if (statistics_.state == CanState::BusOff) return tl::unexpected(bus_off_error(name_));
    if (cursors_.is_strict()) {
      const CanRecord* expected = cursors_.next_out();
      if (expected == nullptr) {
        return fail(Errc::Disconnected, name_ + ": the trace has nothing more that was sent");
      }
      if (expected->frame != frame) return deviation(*expected, frame);
      cursors_.step_out();
      changed_.notify_all();
    }
    ++statistics_.sent;
    return {};
  }

  Result<CanFrame> receive(Time deadline) override {
    std::unique_lock lock(mutex_);
    while (true) {
      wait_on(changed_, lock, clock_, deadline,
              [&] { return cursors_.is_readable() || cursors_.is_over(); });
      if (cursors_.is_over()) return fail(Errc::Disconnected, name_ + ": the trace ends here");
      if (!cursors_.is_readable()) return fail(Errc::Timeout, name_ + ": no frame came in time");
      const CanFrame frame = cursors_.next_in()->frame;
      cursors_.step_in();
      if (frame.error) {
        if (auto gone = note_report(frame, statistics_, name_)) return tl::unexpected(*gone);
        continue;
      }
      if (statistics_.state == CanState::BusOff) statistics_.state = CanState::Active;
      if (!passes(frame)) continue;
      ++statistics_.received;
      return frame;
    }
  }

  Result<void> set_filters(std::span<const CanFilter> filters) override {
    const std::lock_guard lock(mutex_);
    filters_.assign(filters.begin(), filters.end());
    return {};
  }

  [[nodiscard]] CanStatistics statistics() const override {
    const std::lock_guard lock(mutex_);
    return statistics_;
  }
  [[nodiscard]] std::string_view name() const override { return name_; }

 private:
  [[nodiscard]] bool passes(const CanFrame& frame) const {
    return filters_.empty() ||
           std::ranges::any_of(filters_, [&](const CanFilter& f) { return f.passes(frame); });
  }
  [[nodiscard]] tl::unexpected<Error> deviation(const CanRecord& expected,
                                                const CanFrame& frame) const {
    CanRecord found = expected;
    found.frame = frame;
    return fail(Errc::Corrupt, name_ + ": " + cursors_.place() + ": found '" + to_line(found) +
                                   "', expected '" + to_line(expected) + "'");
  }

  ReplayCursors<CanRecord> cursors_;
  const std::string name_;
  Clock& clock_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<CanFilter> filters_;
  CanStatistics statistics_;
};

}  // namespace

std::unique_ptr<CanBus> make_replay_bus(std::vector<CanRecord> records, std::string name,
                                        ReplayMode mode, Clock& clock) {
  return std::make_unique<ReplayBus>(std::move(records), std::move(name), mode, clock);
}

}  // namespace eyebridge::bridges
