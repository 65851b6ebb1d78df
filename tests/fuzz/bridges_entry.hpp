#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#include "eyebridge/bridges/can/messages.hpp"
#include "eyebridge/bridges/can/zones.hpp"
#include "eyebridge/bridges/io7/help_list.hpp"
#include "eyebridge/bridges/io7/reply_parser.hpp"
#include "eyebridge/bridges/open.hpp"
#include "eyebridge/bridges/trace.hpp"

// What the fuzz targets of the bridges and the test over their corpora do with one input. A wrong
// accept ends the process: that is a finding.
namespace eyebridge::fuzz {

inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

inline void require(bool truth) {
  if (!truth) std::abort();
}

/// The first byte picks the dialect, the second the letter; the rest is what the board sends,
/// twice.
inline void io7_reply(std::string_view text) {
  using namespace bridges;
  const auto input = bytes_of(text);
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

inline void io7_help(std::string_view text) {
  using namespace bridges;
  const auto letters = io7::parse_help(text);
  if (!letters) return;
  for (int code = 0; code < 128; ++code) {
    const char letter = static_cast<char>(code);
    require(!letters->has(letter) || letter == IO7_HELP ||
            text.find(letter) != std::string_view::npos);
  }
}

/// Two bytes of identifier and format, then the data; what is read must be written the same.
inline void can_frame(std::string_view text) {
  using namespace bridges;
  const auto input = bytes_of(text);
  if (input.size() < 2) return;
  CanFrame frame;
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
  if (const auto* zones = std::get_if<can::ZoneChunk>(&message->message)) {
    can::ZoneAssembler assembler;
    require(assembler.push(*zones) == nullptr && assembler.push(*zones) == nullptr);
  }
}

/// What a trace reader accepts is written and read the same, whatever the line breaks and comments.
template <class Record>
void trace_of(std::string_view text,
              std::vector<Record> (*read)(std::string_view, const std::string&)) {
  std::vector<Record> records;
  try {
    records = read(text, "fuzz.trace");
  } catch (const ConfigError& error) {
    require(std::string_view(error.what()).starts_with("fuzz.trace:"));
    return;
  }
  std::string written;
  for (const Record& record : records) written += to_line(record) + '\n';
  require(read(written, "again.trace") == records);
}

/// The text as a trace of bytes and as one of frames (candump -L).
inline void trace(std::string_view text) {
  trace_of<bridges::ByteRecord>(text, bridges::read_byte_trace);
  trace_of<bridges::CanRecord>(text, bridges::read_can_trace);
}

/// The text as the URL of each kind of line: what is accepted keeps the promises of its settings.
inline void url(std::string_view text) {
  const SourceLocation where{"fuzz"};
  Url parsed;
  try {
    parsed = parse_url(text, where);
  } catch (const ConfigError&) {  // the input is no URL
    return;
  }
  try {
    const auto serial = bridges::serial_settings(parsed, where);
    require(serial.baud > 0 && !serial.device.empty());
    require(serial.device.find('\0') == std::string::npos);
  } catch (const ConfigError&) {  // no serial port
  }
  try {
    const auto tcp = bridges::tcp_settings(parsed, where);
    require(tcp.port > 0 && !tcp.host.empty() && tcp.connect_timeout.count() > 0);
    require(tcp.host.find('\0') == std::string::npos);
  } catch (const ConfigError&) {  // no TCP address
  }
  try {
    const auto can = bridges::socket_can_settings(parsed, where);
    const bool is_path = can.interface.find('/') != std::string::npos;
    require(!can.interface.empty() && can.interface.size() < (is_path ? 108U : 16U));
    require(can.interface.find('\0') == std::string::npos && can.receive_buffer > 0);
  } catch (const ConfigError&) {  // no CAN interface
  }
}

}  // namespace eyebridge::fuzz
