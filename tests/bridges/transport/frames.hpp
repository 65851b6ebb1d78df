#pragma once

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "eyebridge/bridges/can_frame.hpp"

namespace eyebridge::bridges::testing {

inline CanFrame standard(std::uint32_t id, std::initializer_list<std::uint8_t> data) {
  CanFrame frame;
  frame.id = id;
  frame.length = static_cast<std::uint8_t>(data.size());
  std::ranges::copy(data, frame.data.begin());
  return frame;
}

/// A frame whose data is `number`.
inline CanFrame numbered(std::uint32_t number) {
  return standard(0x100, {static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8),
                          static_cast<std::uint8_t>(number >> 16)});
}
inline std::uint32_t number_in(const CanFrame& frame) {
  return frame.data[0] | static_cast<std::uint32_t>(frame.data[1]) << 8 |
         static_cast<std::uint32_t>(frame.data[2]) << 16;
}

/// An error frame of the class `id` with `controller` as the state of the controller.
inline CanFrame report(std::uint32_t id, std::uint8_t controller) {
  CanFrame frame = standard(id, {0, controller, 0, 0, 0, 0, 0, 0});
  frame.error = true;
  return frame;
}

/// Standard and extended identifiers at their limits, remote, each length, CAN FD with its flags.
inline std::vector<CanFrame> frames_of_all_kinds() {
  std::vector<CanFrame> frames{standard(0, {}), standard(0x7FF, {0, 0xFF, 3, 4, 5, 6, 7, 8})};
  CanFrame extended = standard(0x1FFFFFFF, {1, 2});
  extended.extended = true;
  CanFrame low_extended = standard(0x123, {9});
  low_extended.extended = true;
  CanFrame remote = standard(0x321, {});
  remote.remote = true;
  remote.length = 8;
  frames.insert(frames.end(), {extended, low_extended, remote});
  for (std::size_t length = 0; length <= CanFrame::kMaxFd; ++length) {
    if (!is_can_length(length, true)) continue;
    CanFrame frame;
    frame.id = 0x2D1;
    frame.fd = true;
    frame.length = static_cast<std::uint8_t>(length);
    frame.bit_rate_switch = length % 2 == 0;
    frame.error_state_indicator = length % 3 == 0;
    for (std::size_t i = 0; i < length; ++i) frame.data[i] = static_cast<std::uint8_t>(255 - 3 * i);
    frames.push_back(frame);
  }
  return frames;
}

inline std::vector<CanFrame> impossible_frames() {
  CanFrame nine = standard(1, {});
  nine.length = 9;
  CanFrame too_long_id = standard(0x800, {});
  CanFrame too_long_extended = standard(0x2000'0000, {});
  too_long_extended.extended = true;
  CanFrame remote_fd = standard(1, {});
  remote_fd.remote = remote_fd.fd = true;
  CanFrame fd_of_9 = nine;
  fd_of_9.fd = true;
  CanFrame fd_of_65 = fd_of_9;
  fd_of_65.length = 65;
  CanFrame classic_with_fd_flag = standard(1, {});
  classic_with_fd_flag.bit_rate_switch = true;
  return {nine,    too_long_id, too_long_extended,    remote_fd,
          fd_of_9, fd_of_65,    classic_with_fd_flag, report(4, 0)};
}

}  // namespace eyebridge::bridges::testing
