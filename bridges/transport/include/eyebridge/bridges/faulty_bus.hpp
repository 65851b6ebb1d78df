#pragma once

#include <atomic>
#include <deque>
#include <memory>

#include "eyebridge/bridges/can_bus.hpp"
#include "eyebridge/bridges/faults.hpp"

namespace eyebridge::bridges {

class FaultEngine;

/// A bus that damages what passes through another one. For tests and demonstrations. Splitting and
/// merging do not apply. A late frame going out holds its sender up.
class FaultyBus final : public CanBus {
 public:
  /// `clock`, the one of `inner`, must outlive this.
  FaultyBus(std::unique_ptr<CanBus> inner, const FaultPlan& plan, Clock& clock);
  ~FaultyBus() override;
  FaultyBus(const FaultyBus&) = delete;
  FaultyBus& operator=(const FaultyBus&) = delete;

  Result<void> send(const CanFrame& frame, Time deadline) override;
  Result<CanFrame> receive(Time deadline) override;
  Result<void> set_filters(std::span<const CanFilter> filters) override {
    return inner_->set_filters(filters);
  }
  /// Of the bus below, but `sent` and `received` count what was asked for and handed out here.
  [[nodiscard]] CanStatistics statistics() const override;
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }

  /// Any thread.
  [[nodiscard]] FaultCounts counts() const;

 private:
  struct Arrived {
    CanFrame frame;
    Time due{};
  };

  [[nodiscard]] tl::unexpected<Error> unplugged() const;

  std::unique_ptr<CanBus> inner_;
  Clock& clock_;
  std::unique_ptr<FaultEngine> incoming_;
  std::unique_ptr<FaultEngine> outgoing_;
  std::deque<Arrived> arrived_;  // only the receiver's
  std::atomic<bool> unplugged_ = false;
  std::atomic<std::uint64_t> sent_ = 0;
  std::atomic<std::uint64_t> received_ = 0;
};

}  // namespace eyebridge::bridges
