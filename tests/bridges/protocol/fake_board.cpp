#include "fake_board.hpp"

#include <cstdlib>
#include <utility>

namespace eyebridge::bridges::io7 {

std::vector<std::uint8_t> FakeBoard::answer(std::span<const std::uint8_t> sent) {
  std::string out;
  if (!silent) {
    for (const std::uint8_t byte : sent) take(byte, out);
  }
  return {out.begin(), out.end()};
}

void FakeBoard::take(std::uint8_t byte, std::string& out) {
  if (!binary) {
    if (echo) out += static_cast<char>(byte);
    line_ += static_cast<char>(byte);
    if (!line_.ends_with(line_end)) return;
    line_.resize(line_.size() - line_end.size());
    const std::string line = std::exchange(line_, "");
    if (echo) out += "\n";
    if (!line.empty()) reply(line[0], line.size() > 2 ? std::atoi(line.c_str() + 2) : 0, out);
    if (verbose || prompt_after_raw || line.empty() || line[0] == 'h') {
      out += (line.empty() ? "\r\n" : "") + prompt;
    }
    return;
  }
  if (pending_ != 0) {
    reply(std::exchange(pending_, '\0'), byte, out);
  } else if (byte == 'O' || byte == 'a' || byte == 'p') {
    pending_ = static_cast<char>(byte);
  } else {
    reply(static_cast<char>(byte), 0, out);
  }
}

std::string FakeBoard::number(const char* label, int value, int width) const {
  if (verbose) return std::string(label) + ": " + std::to_string(value) + "\r\n";
  const char high = static_cast<char>(value >> 8);
  const char low = static_cast<char>(value);
  if (width == 1) return {low};
  return msb_first ? std::string{high, low} : std::string{low, high};
}

void FakeBoard::reply(char letter, int argument, std::string& out) {
  const bool known = std::string("hOEmpvVa").find(letter) != std::string::npos;
  if (known) asked += letter;
  if (letter == 'h') out += list;
  if (letter == 'O' && quietens && argument <= 1) verbose = argument == 1;
  if (letter == 'v') out += verbose ? "Version: " + version + "\r\n" : version;
  if (letter == 'V') out += number("Voltage", battery_cv, 2);
  if (letter == 'a' && (argument == 0 || loose)) out += number("Analog", analog_0, 2);
  if (letter == 'p' && argument >= 1 && argument <= 6) out += number("PSD", 512, 2);
}

}  // namespace eyebridge::bridges::io7
