#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace eyebridge::bridges::io7 {

/// A board that answers like one dialect of IO7, for the probe: enough of the command page to be
/// found out, and a record of all that was asked. Written without the codec under test.
struct FakeBoard {
  bool binary = false;   ///< Requests are bytes.
  bool verbose = true;   ///< Replies are text.
  bool quietens = true;  ///< `O 0` works.
  bool msb_first = true;
  bool echo = false;
  bool prompt_after_raw = false;
  bool silent = false;
  bool loose = false;  ///< A reading of any channel is answered.
  std::string prompt = ">";
  std::string line_end = "\r";  ///< What ends a request.
  std::string version = "1.04";
  int battery_cv = 740;
  int analog_0 = 2800;
  std::string list =
      "h help\r\nO output\r\nE demo\r\nm motor\r\np psd\r\nv version\r\nV volt\r\na analog\r\n";

  std::string asked;  ///< Every letter that was understood, in order.

  /// What comes back for `sent`, until the line is quiet.
  std::vector<std::uint8_t> answer(std::span<const std::uint8_t> sent);

 private:
  void take(std::uint8_t byte, std::string& out);
  void reply(char letter, int argument, std::string& out);
  [[nodiscard]] std::string number(const char* label, int value, int width) const;

  std::string line_;
  char pending_ = 0;
};

}  // namespace eyebridge::bridges::io7
