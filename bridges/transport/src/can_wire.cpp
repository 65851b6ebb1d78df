#include "can_wire.hpp"

#include <algorithm>
#include <cstring>

#include "eyebridge/bridges/can_socket_bytes.hpp"

namespace eyebridge::bridges {

// can_frame and canfd_frame begin alike: identifier, length, three bytes, data. So the longer one
// serves for both.
static_assert(offsetof(can_frame, data) == offsetof(canfd_frame, data));

std::size_t to_wire(const CanFrame& frame, canfd_frame& out) {
  out = {};
  out.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) |
               (frame.remote ? CAN_RTR_FLAG : 0U) | (frame.error ? CAN_ERR_FLAG : 0U);
  out.len = frame.length;
  if (frame.fd) {
    out.flags = static_cast<__u8>((frame.bit_rate_switch ? CANFD_BRS : 0) |
                                  (frame.error_state_indicator ? CANFD_ESI : 0));
  }
  std::ranges::copy(frame.bytes(), out.data);
  return frame.fd ? CANFD_MTU : CAN_MTU;
}

CanSocketBytes socket_bytes(const CanFrame& frame) {
  canfd_frame wire;
  CanSocketBytes out;
  static_assert(sizeof wire == sizeof out.bytes);
  out.size = to_wire(frame, wire);
  std::memcpy(out.bytes.data(), &wire, out.size);
  return out;
}

std::optional<CanFrame> from_wire(const canfd_frame& in, std::size_t size) {
  if (size != CAN_MTU && size != CANFD_MTU) return std::nullopt;
  CanFrame frame;
  frame.fd = size == CANFD_MTU;
  frame.extended = (in.can_id & CAN_EFF_FLAG) != 0;
  frame.remote = (in.can_id & CAN_RTR_FLAG) != 0;
  frame.error = (in.can_id & CAN_ERR_FLAG) != 0;
  frame.id = in.can_id & (frame.extended || frame.error ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.length = in.len;
  if (in.len > (frame.fd ? CanFrame::kMaxFd : CanFrame::kMaxClassic)) return std::nullopt;
  if (frame.fd) {
    frame.bit_rate_switch = (in.flags & CANFD_BRS) != 0;
    frame.error_state_indicator = (in.flags & CANFD_ESI) != 0;
  }
  if (!frame.remote) std::copy_n(in.data, in.len, frame.data.begin());
  return frame;
}

}  // namespace eyebridge::bridges
