#include "eyebridge/ports/port.hpp"

#include "eb_board.h"
#include "rv_rover.h"

namespace eyebridge::ports {

ByteLine byte_line(eb_board& board) {
  return {[&board](std::span<const std::uint8_t> bytes) {
            eb_board_receive(&board, bytes.data(), bytes.size());
          },
          [&board](std::span<std::uint8_t> out) {
            return eb_board_transmit(&board, out.data(), out.size());
          },
          [&board] { eb_board_link_lost(&board); }};
}

FrameLine frame_line(eb_board& board) {
  return {[&board](const eb_can_frame& frame) { eb_board_can_receive(&board, &frame); },
          [&board](eb_can_frame& frame) { return eb_board_can_transmit(&board, &frame); },
          [&board] { eb_board_can_lost(&board); }};
}

FrameLine frame_line(rv_rover& rover) {
  return {[&rover](const eb_can_frame& frame) { rv_rover_receive(&rover, &frame); },
          [&rover](eb_can_frame& frame) { return rv_rover_transmit(&rover, &frame); },
          [&rover] { rv_rover_lost(&rover); }};
}

}  // namespace eyebridge::ports
