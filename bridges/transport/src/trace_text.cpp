#include <algorithm>
#include <chrono>

#include "eyebridge/bridges/trace.hpp"
#include "trace_line.hpp"

namespace eyebridge::bridges {
namespace {

using std::chrono::duration_cast;
using std::chrono::microseconds;
using std::chrono::seconds;

constexpr char kHex[] = "0123456789ABCDEF";

void put_hex(std::string& out, std::uint32_t value, int digits) {
  for (int digit = digits - 1; digit >= 0; --digit) out += kHex[(value >> (4 * digit)) & 0xFU];
}

void put_bytes(std::string& out, std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) put_hex(out, byte, 2);
}

// Linux marks error frames in the identifier, and candump writes them so.
constexpr std::uint32_t kErrorMark = 0x2000'0000;

void put_frame(std::string& out, const CanFrame& frame) {
  const bool long_id = frame.extended || frame.error;
  put_hex(out, frame.id | (frame.error ? kErrorMark : 0), long_id ? 8 : 3);
  out += '#';
  if (frame.fd) {
    out += '#';
    put_hex(out, (frame.bit_rate_switch ? 1U : 0U) | (frame.error_state_indicator ? 2U : 0U), 1);
  }
  if (frame.remote) {
    out += 'R';
    if (frame.length > 0) put_hex(out, frame.length, 1);
  }
  put_bytes(out, frame.bytes());
}

void read_flags(LineReader& line, CanFrame& frame) {
  const std::uint32_t flags = line.hex(1, "a digit of CAN FD flags");
  if (flags > 7) line.fail("a digit of CAN FD flags, 0 to 7");
  frame.fd = true;  // 4 says the same once more
  frame.bit_rate_switch = (flags & 1U) != 0;
  frame.error_state_indicator = (flags & 2U) != 0;
}

void read_id(LineReader& line, CanFrame& frame) {
  const std::size_t digits = line.hex_digits();
  if (digits != 3 && digits != 8) line.fail("an identifier of 3 or 8 hex digits");
  frame.extended = digits == 8;
  frame.id = line.hex(digits, "an identifier");
  if (frame.extended && (frame.id & kErrorMark) != 0) {
    frame.error = true;
    frame.extended = false;
    frame.id &= ~kErrorMark;
  }
  if (frame.id > (digits == 8 ? CanFrame::kMaxExtendedId : CanFrame::kMaxStandardId)) {
    line.fail("an identifier of at most 11 bits in 3 or 29 bits in 8 digits, before this");
  }
}

CanFrame read_frame(LineReader& line) {
  CanFrame frame;
  read_id(line, frame);
  line.expect('#');
  if (line.take('#')) {
    if (frame.error) line.fail("data: error frames are classic");
    read_flags(line, frame);
  } else if (!frame.error && line.take('R')) {
    frame.remote = true;
    if (line.hex_digits() > 0) {
      frame.length = static_cast<std::uint8_t>(line.hex(1, "a length"));
      if (frame.length > CanFrame::kMaxClassic) line.fail("a length of at most 8, before this");
    }
    return frame;
  }
  const std::size_t digits = line.hex_digits();
  if (digits % 2 != 0 || digits > 2 * CanFrame::kMaxFd || !is_can_length(digits / 2, frame.fd)) {
    line.fail(frame.fd ? "two hex digits for each of 0 to 8, 12, 16, 20, 24, 32, 48 or 64 bytes"
                       : "two hex digits for each of 0 to 8 bytes");
  }
  frame.length = static_cast<std::uint8_t>(digits / 2);
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data[i] = static_cast<std::uint8_t>(line.hex(2, "a byte"));
  }
  return frame;
}

ByteRecord read_byte_record(LineReader& line) {
  ByteRecord record;
  record.time = microseconds(line.number(LineReader::kMaxMicroseconds, "microseconds"));
  line.expect(' ');
  if (line.take('>')) {
    record.direction = Direction::Out;
  } else {
    if (!line.take('<')) line.fail("'<' for bytes that came in or '>' for such that went out");
  }
  line.expect(' ');
  const std::size_t digits = line.hex_digits();
  if (digits == 0 || digits % 2 != 0) line.fail("two hex digits for each byte");
  record.bytes.reserve(digits / 2);
  for (std::size_t i = 0; i < digits / 2; ++i) {
    record.bytes.push_back(static_cast<std::uint8_t>(line.hex(2, "a byte")));
  }
  line.expect_end();
  return record;
}

CanRecord read_can_record(LineReader& line) {
  CanRecord record;
  line.expect('(');
  const auto whole = line.number(LineReader::kMaxMicroseconds / 1'000'000 - 1, "seconds");
  line.expect('.');
  if (line.decimal_digits() != 6) line.fail("6 digits of microseconds");
  record.time = seconds(whole) + microseconds(line.number(999'999, "microseconds"));
  line.expect(')');
  line.expect(' ');
  record.interface = line.word("the name of an interface");
  line.expect(' ');
  record.frame = read_frame(line);
  if (!line.at_end()) {
    line.expect(' ');
    if (line.take('R')) {
      record.direction = Direction::In;
    } else if (line.take('T')) {
      record.direction = Direction::Out;
    } else {
      line.fail("R for received, T for transmitted, or nothing");
    }
  }
  line.expect_end();
  return record;
}

template <class Record>
std::vector<Record> read_lines(std::string_view text, const std::string& file,
                               Record (*read)(LineReader&)) {
  std::vector<Record> records;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (content.ends_with('\r')) content.remove_suffix(1);
    while (content.ends_with(' ')) content.remove_suffix(1);
    if (content.empty() || content.starts_with('#')) continue;
    LineReader line(content, file, number);
    records.push_back(read(line));
  }
  return records;
}

}  // namespace

std::string to_line(const ByteRecord& record) {
  std::string out = std::to_string(duration_cast<microseconds>(record.time).count());
  out += record.direction == Direction::Out ? " > " : " < ";
  put_bytes(out, record.bytes);
  return out;
}

std::string to_line(const CanRecord& record) {
  const auto whole = duration_cast<seconds>(record.time);
  const std::string rest = std::to_string(duration_cast<microseconds>(record.time - whole).count());
  std::string out = "(" + std::to_string(whole.count()) + "." +
                    std::string(6 - std::min<std::size_t>(rest.size(), 6), '0') + rest + ") " +
                    record.interface + " ";
  put_frame(out, record.frame);
  if (record.direction == Direction::In) out += " R";
  if (record.direction == Direction::Out) out += " T";
  return out;
}

std::vector<ByteRecord> read_byte_trace(std::string_view text, const std::string& file) {
  return read_lines(text, file, read_byte_record);
}

std::vector<CanRecord> read_can_trace(std::string_view text, const std::string& file) {
  return read_lines(text, file, read_can_record);
}

}  // namespace eyebridge::bridges
