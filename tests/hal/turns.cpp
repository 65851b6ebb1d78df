#include "turns.hpp"

#include <algorithm>
#include <utility>

namespace eyebridge::hal::testing {
namespace {

using namespace std::chrono_literals;

constexpr Time kTurn = 500us;  // some six bytes at 115200 baud
constexpr Time kHostPeriod = 10ms;

class TurnStream final : public bridges::ByteStream {
 public:
  TurnStream(std::unique_ptr<bridges::ByteStream> line, TurnClock& clock)
      : line_(std::move(line)), clock_(clock) {}

  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    while (true) {
      auto count = line_->read_some(buffer, Time{0});
      const bool nothing = !count && count.error().code == Errc::Timeout;
      if (!nothing || clock_.now() >= deadline) return count;
      clock_.listen_until(std::min(deadline, clock_.now() + kTurn));
    }
  }
  Result<void> write_all(std::span<const std::uint8_t> bytes, Time) override {
    return line_->write_all(bytes, Time{0});
  }
  void close() override { line_->close(); }
  [[nodiscard]] std::string_view name() const override { return line_->name(); }

 private:
  const std::unique_ptr<bridges::ByteStream> line_;
  TurnClock& clock_;
};

class TurnBus final : public bridges::CanBus {
 public:
  TurnBus(std::unique_ptr<bridges::CanBus> bus, TurnClock& clock)
      : bus_(std::move(bus)), clock_(clock) {}

  Result<void> send(const bridges::CanFrame& frame, Time) override {
    return bus_->send(frame, Time{0});
  }
  Result<bridges::CanFrame> receive(Time deadline) override {
    while (true) {
      auto frame = bus_->receive(Time{0});
      const bool nothing = !frame && frame.error().code == Errc::Timeout;
      if (!nothing || clock_.now() >= deadline) return frame;
      clock_.listen_until(std::min(deadline, clock_.now() + kTurn));
    }
  }
  Result<void> set_filters(std::span<const bridges::CanFilter> filters) override {
    return bus_->set_filters(filters);
  }
  [[nodiscard]] bridges::CanStatistics statistics() const override { return bus_->statistics(); }
  [[nodiscard]] std::string_view name() const override { return bus_->name(); }

 private:
  const std::unique_ptr<bridges::CanBus> bus_;
  TurnClock& clock_;
};

}  // namespace

void TurnClock::listen_until(Time deadline) {
  while (now_ < deadline) {
    now_ = std::min(deadline, now_ + kTurn);
    if (board) board(now_);
  }
}

void TurnClock::wait_until(Time deadline) {
  while (now_ < deadline) {
    const Time next = host ? std::min(deadline, std::max(host_due_, now_)) : deadline;
    if (listen && next > now_ && !listening_) {
      listening_ = true;
      listen(next);
      listening_ = false;
    } else {
      listen_until(next);
    }
    if (!host || now_ < host_due_) continue;
    host_due_ = std::max(host_due_ + kHostPeriod, now_);
    host();
  }
}

std::unique_ptr<bridges::ByteStream> by_turns(std::unique_ptr<bridges::ByteStream> line,
                                              TurnClock& clock) {
  return std::make_unique<TurnStream>(std::move(line), clock);
}

std::unique_ptr<bridges::CanBus> by_turns(std::unique_ptr<bridges::CanBus> bus, TurnClock& clock) {
  return std::make_unique<TurnBus>(std::move(bus), clock);
}

}  // namespace eyebridge::hal::testing
