#include "eyebridge/bridges/can_frame.hpp"

namespace eyebridge::bridges {

const char* why_not_sendable(const CanFrame& frame) {
  if (frame.error) return "found an error frame, expected one for the bus: only controllers report";
  if (frame.id > (frame.extended ? CanFrame::kMaxExtendedId : CanFrame::kMaxStandardId)) {
    return frame.extended ? "found an identifier of more than 29 bits"
                          : "found an identifier of more than 11 bits in a standard frame";
  }
  if (frame.fd && frame.remote) return "found a remote CAN FD frame: there are none";
  if (!frame.fd && (frame.bit_rate_switch || frame.error_state_indicator)) {
    return "found a CAN FD flag in a classic frame";
  }
  if (!is_can_length(frame.length, frame.fd)) {
    return frame.fd ? "found a length that no CAN FD frame has; expected 0 to 8, 12, 16, 20, 24, "
                      "32, 48 or 64"
                    : "found more than 8 bytes in a classic frame";
  }
  return nullptr;
}

}  // namespace eyebridge::bridges
