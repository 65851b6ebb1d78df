#include <string>

#include <gmock/gmock.h>

#include "board_fixture.hpp"
#include "golden.hpp"
#include "opcodes.h"

namespace eyebridge::firmware {
namespace {

using bridges::test::bytes_from_hex;
using bridges::test::golden_lines;

/// A golden line, taken apart: form, letter, numbers, bytes.
struct Golden {
  std::string form;
  char letter = 0;
  std::vector<std::string> values;
  std::vector<std::uint8_t> bytes;
};

std::vector<Golden> golden(const std::string& kind) {
  std::vector<Golden> found;
  for (const auto& words : golden_lines("io7.hex")) {
    if (words[0] != kind) continue;
    Golden line{words[1], words[2][0], {}, {}};
    std::size_t at = 3;
    for (; words[at] != ":"; ++at) line.values.push_back(words[at]);
    std::string hex;
    for (++at; at < words.size(); ++at) hex += words[at];
    line.bytes = bytes_from_hex(hex);
    found.push_back(line);
  }
  return found;
}

eb_config dialect(const std::string& form) {
  return config_with([&](eb_config& config) {
    config.io7.letters = EB_LETTERS_ALL;
    config.io7.binary = form.starts_with("binary");
    config.io7.lsb_first = form.ends_with("lsb");
    config.io7.verbose = form.starts_with("text");
    if (form.ends_with("prompt")) config.io7.prompt[0] = '>';
    config.io7.prompt_after_raw = form == "raw-prompt";
  });
}

TEST(FirmwareIo7Golden, EveryRequestIsReadAsInTheFile) {
  for (const Golden& line : golden("request")) {
    eb_io7 io7;
    const eb_config config = dialect(line.form);
    eb_io7_init(&io7, &config);
    eb_request request{};
    int requests = 0;
    for (const std::uint8_t byte : line.bytes) {
      const eb_found found = eb_io7_push(&io7, byte, &request);
      EXPECT_NE(found, EB_FOUND_ERROR) << line.letter;
      if (found == EB_FOUND_REQUEST) ++requests;
    }
    ASSERT_EQ(requests, 1) << line.form << " " << line.letter;
    EXPECT_EQ(request.letter, line.letter);
    ASSERT_EQ(request.count, line.values.size());
    for (std::size_t i = 0; i < line.values.size(); ++i) {
      const std::string& word = line.values[i];
      const bool letter = word.size() == 1 && std::string("ioIJ").find(word) != std::string::npos;
      EXPECT_EQ(request.argument[i], letter ? word[0] : std::stoi(word)) << line.letter;
    }
  }
}

/// Makes the board's pins such that `line` is the answer; returns the request, as ASCII.
std::string arrange(eb_board& board, const Golden& line) {
  const auto number = [&](std::size_t i) { return std::stoi(line.values[i]); };
  const auto word = [&](std::size_t i) { return static_cast<std::uint16_t>(number(i)); };
  switch (line.letter) {
    case 'V':
      board.pins.supply_cv = word(0);
      return "V\r";
    case 'p':
      board.pins.psd[0] = word(0);
      return "p 1\r";
    case 'e':
      board.pins.encoder[0] = word(0);
      return "e 1\r";
    case 'I':
      board.pins.digital_driven = 0xFFFF;
      board.pins.digital_in = word(0);
      for (int port = 0; port < EB_PORTS; ++port) eb_board_port(&board, port, IO7_PORT_INPUT);
      return "I\r";
    case 'i':
      board.pins.digital_driven = 1;
      board.pins.digital_in = word(0);
      return "i 0\r";
    case 'a':
      board.pins.analog[1] = word(0);
      return "a 1\r";
    case 'q':
      eb_drive_set_pose(&board.drive, number(0), number(1), number(2) * 100);
      return "q\r";
    case 'z':
      board.drive.distance.open = true;
      board.drive.distance.left = static_cast<float>(number(0)) * 0.001F;
      return "z\r";
    case 'Z':
      board.drive.move_state = number(0) < 0    ? EYECAN_MOVE_ABORTED
                               : number(0) == 0 ? EYECAN_MOVE_RUNNING
                                                : EYECAN_MOVE_DONE;
      return "Z\r";
    default:
      return {line.letter, '\r'};
  }
}

/// The line end that these bytes have, before a prompt; empty when they are raw.
std::string line_end_of(const Golden& line) {
  std::string text(line.bytes.begin(), line.bytes.end());
  if (text.ends_with('>')) text.pop_back();
  const std::size_t end = text.find_last_not_of("\r\n");
  return text.substr(end + 1);
}

TEST(FirmwareIo7Golden, EveryReplyIsWrittenAsInTheFile) {
  int compared = 0;
  for (const Golden& line : golden("reply")) {
    const std::string expected(line.bytes.begin(), line.bytes.end());
    // Labels and signed counters are other boards' text; X needs a moving robot, z is never < 0
    // here.
    if (line.form.starts_with("text") && expected.find_first_of(":=") != std::string::npos)
      continue;
    if (line.letter == 'X' || (line.letter == 'z' && line.values[0][0] == '-')) continue;
    eb_config config = dialect(line.form);
    if (config.io7.verbose) line_end_of(line).copy(config.io7.line_end, 2);
    if (config.io7.verbose) config.io7.line_end[line_end_of(line).size()] = '\0';
    BoardUnderTest host(config);
    const std::string request = arrange(host.board, line);
    EXPECT_EQ(host.ask(request), expected) << line.form << " " << line.letter;
    ++compared;
  }
  EXPECT_GE(compared, 30);
}

}  // namespace
}  // namespace eyebridge::firmware
