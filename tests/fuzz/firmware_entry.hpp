#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "eb_board.h"

// What the fuzz target of the board firmware and the test over its corpus do with one input.
namespace eyebridge::fuzz {

/// Ends the process unless the board's outputs are within what its wires can carry.
inline void require_sane(const eb_board& board) {
  bool sane = board.io7.reply_count <= EB_REPLY && board.io7.length <= EB_LINE;
  for (const std::int16_t duty : board.pins.duty) {
    sane = sane && duty >= -EB_DUTY_FULL && duty <= EB_DUTY_FULL;
  }
  for (const std::uint16_t pulse : board.pins.servo_us) sane = sane && pulse <= 2550;
  if (!sane || (board.pins.digital_out & ~board.pins.digital_outputs) != 0) std::abort();
}

/// The first byte picks the dialect. Then byte by byte: 0xFE and two bytes are time and an encoder,
/// 0xFF, two bytes of identifier and length and the data are a frame; all else comes by the serial
/// line.
inline void firmware(std::string_view text) {
  if (text.empty()) return;
  const auto at = [text](std::size_t i) {
    return static_cast<std::uint8_t>(i < text.size() ? text[i] : 0);
  };
  eb_config config;
  eb_config_default(&config);
  config.io7.binary = (at(0) & 1) != 0;
  config.io7.verbose = (at(0) & 2) != 0;
  config.io7.lsb_first = (at(0) & 4) != 0;
  config.io7.echo = (at(0) & 8) != 0;
  if ((at(0) & 16) != 0) config.io7.prompt[0] = '>';
  config.io7.letters = EB_LETTERS_ALL;
  config.node = 1;
  eb_board board;
  eb_board_init(&board, &config, nullptr);
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (at(i) == 0xFE) {
      board.pins.encoder[at(i + 1) & 3] = static_cast<std::uint16_t>(at(i + 2) * 257U);
      eb_board_process(&board, at(i + 1) * 1000U);
      i += 2;
    } else if (at(i) == 0xFF) {
      eb_can_frame frame{};
      frame.id = static_cast<std::uint16_t>((at(i + 1) & 7) << 8 | at(i + 2));
      frame.length = at(i + 1) >> 4;
      i += 2;
      for (int byte = 0; byte < frame.length; ++byte) frame.data[byte] = at(++i);
      eb_board_can_receive(&board, &frame);
    } else {
      const std::uint8_t byte = at(i);
      eb_board_receive(&board, &byte, 1);
    }
    require_sane(board);
  }
  std::uint8_t out[64];
  while (eb_board_transmit(&board, out, sizeof out) > 0) require_sane(board);
  eb_can_frame frame;
  for (int sent = 0; eb_board_can_transmit(&board, &frame); ++sent) {
    // Everything that is due goes out once: an endless stream would block the bus.
    if (sent > 200) std::abort();
  }
}

}  // namespace eyebridge::fuzz
