// What the guard of a CAN robot is told.
#include <algorithm>

#include "eyebridge/bridges/can_socket_bytes.hpp"
#include "eyebridge/bridges/client/can_client.hpp"

namespace eyebridge::bridges {
namespace {

constexpr std::size_t kIdentifier = 4;  // bytes of a frame on a socket

/// Motors at 0 and an emergency stop; the answer is a heartbeat that says so. Who tells the robot a
/// speed has it: every program does, 0, before it enables the robot, and no guard.
Result<StopOrders> stop_orders(const CanBus& bus, int node) {
  StopOrders orders;
  for (const auto& frame : {can::encode(node, can::MotorCommand{.mask = 0xF}),
                            can::encode(node, can::EmergencyStop{EYECAN_ESTOP_HOST_FAULT, 0})}) {
    if (!frame) return tl::unexpected(frame.error());
    (void)orders.writes[orders.count++].add(socket_bytes(bus.on_socket(*frame)).view());
  }
  const auto speed = can::encode(node, can::SpeedCommand{});
  if (!speed) return tl::unexpected(speed.error());
  (void)orders.taken.add(socket_bytes(bus.on_socket(*speed)).view().first(kIdentifier));
  const auto stopped = can::encode(node, can::Heartbeat{EYECAN_STATE_STOPPED});
  if (!stopped) return tl::unexpected(stopped.error());
  (void)orders.answer.add(socket_bytes(bus.on_socket(*stopped)).view());
  // Identifier, length and data; what lies between and behind them is the kernel's.
  const auto mask = orders.mask.bytes.begin();
  std::fill_n(mask, 5, 0xFF);
  std::fill_n(mask + 8, stopped->length, 0xFF);
  orders.frames = true;
  orders.has_watchdog = true;
  return orders;
}

}  // namespace

Result<void> CanClient::guard() {
  if (bus_->descriptor() < 0) {
    return fail(Errc::Unsupported, std::string(bus_->name()) + ": a bus that cannot be guarded");
  }
  return stop_orders(*bus_, node_).and_then([this](const StopOrders& orders) -> Result<void> {
    auto started = LineGuard::start();
    if (!started) return tl::unexpected(std::move(started.error()));
    const std::lock_guard sending(sending_);
    guard_ = std::move(*started);
    return guard_->hold(bus_->descriptor(), who_, orders);
  });
}

void CanClient::tell_guard(bool turning) {
  if (guard_ == nullptr) return;
  if (turning ? guard_->turning(clock_.now()) : guard_->still()) return;
  guard_.reset();
  log_.write(
      Severity::Error,
      who_ + ": its guard was ended: its own watchdog alone stops it if the program crashes");
}

}  // namespace eyebridge::bridges
