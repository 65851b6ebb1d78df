#include "golden.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace eyebridge::bridges::test {

std::vector<std::vector<std::string>> golden_lines(const std::string& name) {
  std::ifstream file(std::string(EYEBRIDGE_SOURCE_DIR) + "/tests/data/protocol/" + name);
  std::vector<std::vector<std::string>> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    lines.emplace_back();
    for (std::string word; words >> word;) lines.back().push_back(word);
  }
  EXPECT_FALSE(lines.empty()) << name << " is missing or empty";
  return lines;
}

std::vector<std::uint8_t> bytes_from_hex(std::string_view hex) {
  std::string digits(hex);
  digits.erase(std::remove(digits.begin(), digits.end(), ' '), digits.end());
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    std::uint8_t byte = 0;
    const char* end = digits.data() + i + 2;
    EXPECT_EQ(std::from_chars(digits.data() + i, end, byte, 16).ptr, end) << hex;
    bytes.push_back(byte);
  }
  return bytes;
}

CanFrame frame_from_text(std::string_view text) {
  CanFrame frame;
  const std::size_t hash = text.find('#');
  std::from_chars(text.data(), text.data() + hash, frame.id, 16);
  text.remove_prefix(hash + 1);
  if (text.starts_with('#')) {
    frame.fd = true;
    text.remove_prefix(2);
  }
  const auto data = bytes_from_hex(text);
  EXPECT_LE(data.size(), frame.data.size());
  frame.length = static_cast<std::uint8_t>(data.size());
  std::copy_n(data.begin(), std::min(data.size(), frame.data.size()), frame.data.begin());
  return frame;
}

io7::Profile profile_of(std::string_view form) {
  io7::Profile profile;
  for (const io7::Command& command : io7::commands()) profile.letters.insert(command.letter);
  profile.vw_letters = true;
  if (form == "ascii-lf") profile.terminator = io7::Terminator::Lf;
  if (form == "ascii-crlf") profile.terminator = io7::Terminator::CrLf;
  if (form.starts_with("binary")) profile.request_form = io7::RequestForm::Binary;
  if (form.ends_with("lsb")) profile.byte_order = io7::ByteOrder::LsbFirst;
  if (form.starts_with("text")) profile.reply_form = io7::ReplyForm::Text;
  if (form.ends_with("prompt")) profile.prompt = {{'>'}, 1};
  profile.prompt_after_raw = form == "raw-prompt";
  return profile;
}

std::vector<std::uint8_t> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

}  // namespace eyebridge::bridges::test
