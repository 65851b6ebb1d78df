#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "eyebridge/bridges/can/messages.hpp"
#include "eyebridge/bridges/io7/help_list.hpp"
#include "eyebridge/bridges/io7/reply_parser.hpp"

// What the fuzz targets and the test over their corpora do with one input. A wrong accept ends the
// process: that is a finding.
namespace eyebridge::bridges::fuzz {

inline void require(bool truth) {
  if (!truth) std::abort();
}

/// The first byte picks the dialect, the second the letter; the rest is what the board sends,
/// twice.
inline void io7_reply(std::span<const std::uint8_t> input) {
  if (input.size() < 2) return;
  io7::Profile profile;
  for (const io7::Command& command : io7::commands()) profile.letters.insert(command.letter);
  profile.vw_letters = true;
  const unsigned form = input[0];
  profile.reply_form = (form & 1U) != 0 ? io7::ReplyForm::Text : io7::ReplyForm::Raw;
  profile.byte_order = (form & 2U) != 0 ? io7::ByteOrder::LsbFirst : io7::ByteOrder::MsbFirst;
  if ((form & 4U) != 0) profile.prompt = {{'>'}, 1};
  profile.prompt_after_raw = (form & 8U) != 0;
  profile.echo = (form & 16U) != 0;
  const io7::Command& command = io7::commands()[input[1] % io7::commands().size()];
  io7::ReplyParser parser;
  for (int time = 0; time < 2; ++time) {
    parser.start(io7::Request{.letter = command.letter}, profile);
    for (const std::uint8_t byte : input.subspan(2)) parser.push(byte);
    parser.quiet();
    const auto reply = parser.reply();
    if (!reply) {
      require(!reply.error().what.empty());
      continue;
    }
    require(reply->count == command.value_count && parser.text().size() <= io7::kMaxReplyText);
    for (std::size_t i = 0; i < reply->count; ++i) {
      require(reply->values[i] >= command.value_fields[i].first &&
              reply->values[i] <= command.value_fields[i].last);
    }
  }
}

inline void io7_help(std::span<const std::uint8_t> input) {
  const std::string_view text(reinterpret_cast<const char*>(input.data()), input.size());
  const auto letters = io7::parse_help(text);
  if (!letters) return;
  for (int code = 0; code < 128; ++code) {
    const char letter = static_cast<char>(code);
    require(!letters->has(letter) || letter == IO7_HELP ||
            text.find(letter) != std::string_view::npos);
  }
}

/// Two bytes of identifier and format, then the data; what is read must be written the same.
inline void can_frame(std::span<const std::uint8_t> input) {
  if (input.size() < 2) return;
  can::Frame frame;
  frame.id = static_cast<std::uint16_t>((input[0] << 8 | input[1]) & 0x7FF);
  frame.fd = (input[0] & 0x80U) != 0;
  const auto data = input.subspan(2);
  const std::size_t length = std::min(data.size(), frame.data.size());
  std::copy_n(data.begin(), length, frame.data.begin());
  frame.length = static_cast<std::uint8_t>(length);
  const auto message = can::decode_any(frame);
  if (!message) return;
  const auto again = can::encode_any(*message);
  require(again.has_value() && again->id == frame.id && again->fd == frame.fd);
  require(can::decode_any(*again) == *message);
}

}  // namespace eyebridge::bridges::fuzz
