#pragma once

#include <memory>
#include <vector>

#include "eyebridge/bridges/can_bus.hpp"

namespace eyebridge::bridges {

/// Where on a bus that others use, too, the 11-bit identifiers of a protocol lie.
struct CanPlace {
  std::uint32_t offset = 0;  ///< Is added to each.
  bool extended = false;     ///< 29-bit identifiers.

  [[nodiscard]] std::uint32_t last_id() const {
    return extended ? CanFrame::kMaxExtendedId : CanFrame::kMaxStandardId;
  }
  friend bool operator==(const CanPlace&, const CanPlace&) = default;
};

/// A bus whose identifiers are elsewhere on the bus under it: what is sent is moved there, what is
/// not there is not received. Sending fails with OutOfRange where there is no such identifier.
class MovedBus final : public CanBus {
 public:
  MovedBus(std::unique_ptr<CanBus> inner, CanPlace place)
      : inner_(std::move(inner)), place_(place) {}

  Result<void> send(const CanFrame& frame, Time deadline) override;
  Result<CanFrame> receive(Time deadline) override;
  Result<void> set_filters(std::span<const CanFilter> filters) override;
  [[nodiscard]] CanStatistics statistics() const override { return inner_->statistics(); }
  [[nodiscard]] int descriptor() const override { return inner_->descriptor(); }
  [[nodiscard]] CanFrame on_socket(const CanFrame& frame) const override;
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }

 private:
  const std::unique_ptr<CanBus> inner_;
  const CanPlace place_;
  std::vector<CanFilter> filters_;
};

}  // namespace eyebridge::bridges
