#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include <gmock/gmock.h>

#include "board_fixture.hpp"
#include "eyebridge/bridges/io7/help_list.hpp"
#include "opcodes.h"

namespace eyebridge::firmware {
namespace {

struct Form {
  const char* name;
  bool binary, verbose, lsb_first;
  const char* prompt;
};
void PrintTo(const Form& form, std::ostream* out) { *out << form.name; }

class Io7Letters : public testing::TestWithParam<Form> {
 protected:
  static eb_config config() {
    return config_with([](eb_config& config) {
      config.io7.letters = EB_LETTERS_ALL;
      config.io7.binary = GetParam().binary;
      config.io7.verbose = GetParam().verbose;
      config.io7.lsb_first = GetParam().lsb_first;
      std::string(GetParam().prompt).copy(config.io7.prompt, 7);
    });
  }
  /// The request in the row's form. `widths` has a digit for each argument: bytes, 0 for a letter.
  static std::string request(char letter, const std::vector<int>& arguments = {},
                             const std::string& widths = "") {
    std::string text(1, letter);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const char width = i < widths.size() ? widths[i] : '1';
      const int value = arguments[i];
      if (!GetParam().binary) {
        text += ' ';
        text += width == '0' ? std::string(1, static_cast<char>(value)) : std::to_string(value);
      } else if (width == '2') {
        text += two(value);
      } else {
        text += static_cast<char>(value);
      }
    }
    return GetParam().binary ? text : text + '\r';
  }
  static std::string two(int value) {
    const char low = static_cast<char>(value & 0xFF);
    const char high = static_cast<char>(value >> 8 & 0xFF);
    return GetParam().lsb_first ? std::string{low, high} : std::string{high, low};
  }
  /// What the board answers with numbers.
  static std::string reply(const std::vector<int>& values, int width = 2) {
    std::string text;
    for (const int value : values) {
      if (GetParam().verbose) {
        text += (text.empty() ? "" : " ") + std::to_string(value);
      } else {
        text += width == 2 ? two(value) : std::string(1, static_cast<char>(value));
      }
    }
    return GetParam().verbose ? text + "\r\n" + GetParam().prompt : text;
  }
  static std::string nothing() { return GetParam().verbose ? GetParam().prompt : ""; }

  BoardUnderTest host{config()};
};

TEST_P(Io7Letters, MotorsTakeTheirDutyAtOnce) {
  for (int motor = 1; motor <= 4; ++motor) {
    for (const int duty : {-100, -1, 0, 50, 100}) {
      EXPECT_EQ(host.ask(request('m', {motor, duty})), nothing());
      EXPECT_EQ(host.board.pins.duty[motor - 1], duty * 100);
    }
  }
}

TEST_P(Io7Letters, ControlledMotorsGetATargetAndGains) {
  EXPECT_EQ(host.ask(request('M', {2, -128})), nothing());
  EXPECT_EQ(host.ask(request('M', {3, 100})), nothing());
  EXPECT_EQ(host.ask(request('d', {2, 9, 0, 255})), nothing());
  const eb_motor& motor = host.board.motors.motor[1];
  EXPECT_TRUE(motor.controlled);
  EXPECT_EQ(motor.target_q8, -110 * 256) << "clamped to what full duty does";
  EXPECT_EQ(host.board.motors.motor[2].target_q8, 100 * 256);
  EXPECT_EQ((std::vector<int>{motor.p, motor.i, motor.d}), (std::vector<int>{9, 0, 255}));
}

TEST_P(Io7Letters, ServosMoveBetweenTheirLimits) {
  host.ask(request('s', {1, 0}));
  host.ask(request('s', {14, 255}));
  EXPECT_EQ(host.board.pins.servo_us[0], 1000);
  EXPECT_EQ(host.board.pins.servo_us[13], 2000);
  EXPECT_EQ(host.board.pins.servo_us[5], 0) << "no pulses before the first position";
  EXPECT_EQ(host.ask(request('S', {1, 70, 150})), nothing());
  host.ask(request('s', {1, 255}));
  EXPECT_EQ(host.board.pins.servo_us[0], 1500);
}

TEST_P(Io7Letters, ReadingsComeFromThePins) {
  for (int i = 0; i < EB_PSDS; ++i) host.board.pins.psd[i] = static_cast<std::uint16_t>(600 + i);
  for (int i = 0; i < EB_ANALOGS; ++i) host.board.pins.analog[i] = static_cast<std::uint16_t>(i);
  for (int i = 0; i < EB_MOTORS; ++i) host.board.pins.encoder[i] = static_cast<std::uint16_t>(-i);
  for (int i = 0; i < EB_PSDS; ++i) EXPECT_EQ(host.ask(request('p', {i + 1})), reply({600 + i}));
  for (int i = 0; i < EB_ANALOGS; ++i) EXPECT_EQ(host.ask(request('a', {i})), reply({i}));
  for (int i = 0; i < EB_MOTORS; ++i) {
    EXPECT_EQ(host.ask(request('e', {i + 1})), reply({(65536 - i) % 65536}));
  }
  EXPECT_EQ(host.ask(request('V')), reply({740}));
  EXPECT_EQ(
      host.ask(request('v')),
      "1.04" + (GetParam().verbose ? std::string("\r\n") + GetParam().prompt : std::string()));
}

TEST_P(Io7Letters, PortsReadTheirLevelsAndPullUps) {
  EXPECT_EQ(host.ask(request('I')), reply({0x00FF})) << "power-up: 0..7 pulled up, 8..15 out";
  host.ask(request('o', {9, 1}));
  EXPECT_EQ(host.board.pins.digital_out, 1U << 9);
  EXPECT_EQ(host.ask(request('i', {9})), reply({1}, 1));
  host.ask(request('c', {0, 'i'}, "10"));
  host.ask(request('c', {1, 'J'}, "10"));
  EXPECT_EQ(host.ask(request('I')), reply({0x02FC}));
  host.board.pins.digital_driven = 0x8004;
  host.board.pins.digital_in = 0x8000;
  host.ask(request('c', {15, 'I'}, "10"));
  EXPECT_EQ(host.ask(request('I')), reply({0x82F8}));
  host.ask(request('o', {9, 0}));
  EXPECT_EQ(host.ask(request('i', {9})), reply({0}, 1));
}

TEST_P(Io7Letters, MovesRunOnTheBoard) {
  Plant plant;
  const auto drive = [&](std::uint32_t ms) {
    host.wait_ms(ms, [&] {
      plant.step(host.board);
      host.board.silent_us = 0;
    });
  };
  EXPECT_EQ(host.ask(request('Q', {100, -200, 90}, "222")), nothing());
  EXPECT_EQ(host.ask(request('y', {200, 300}, "22")), nothing());
  EXPECT_EQ(host.ask(request('Z')), reply({0}, 1));
  EXPECT_EQ(host.ask(request('z')), reply({300}));
  drive(1000);
  EXPECT_EQ(host.ask(request('X')), reply({200, 0}));
  drive(2000);
  EXPECT_EQ(host.ask(request('Z')), reply({1}, 1));
  EXPECT_EQ(host.ask(request('q')), reply({100, 100, 90}));
  host.ask(request('Y', {90, -90}, "22"));
  drive(2000);
  EXPECT_EQ(host.ask(request('q')), reply({100, 100, 0}));
  host.ask(request('C', {314, 180, 200}, "222"));
  drive(4000);
  EXPECT_NEAR(eb_drive_x_mm(&host.board.drive), 100, 2);
  EXPECT_NEAR(eb_drive_y_mm(&host.board.drive), 300, 2);
  EXPECT_NEAR(std::abs(eb_drive_heading_cdeg(&host.board.drive)), 18000, 50);
  host.ask(request('x', {-100, 0}, "22"));
  drive(1000);
  EXPECT_LT(host.board.pins.duty[0], 0);
}

TEST_P(Io7Letters, WhatIsOutOfRangeChangesNothing) {
  const eb_pins before = host.board.pins;
  const std::vector<std::string> wrong = {request('m', {0, 10}),
                                          request('m', {5, 10}),
                                          request('m', {1, 101}),
                                          request('m', {1, -101}),
                                          request('s', {15, 1}),
                                          request('p', {7}),
                                          request('p', {0}),
                                          request('e', {5}),
                                          request('i', {16}),
                                          request('o', {1, 2}),
                                          request('c', {1, 'x'}, "10"),
                                          request('a', {9}),
                                          request('O', {2}),
                                          request('U')};
  for (const std::string& bytes : wrong) {
    const std::string answer = host.ask(bytes);
    EXPECT_TRUE(GetParam().verbose ? answer.starts_with("error") : answer.empty()) << bytes;
    host.wait_ms(30);
  }
  EXPECT_EQ(host.board.io7.bad_requests, wrong.size());
  EXPECT_EQ(std::memcmp(&before, &host.board.pins, sizeof before), 0);
}

TEST_P(Io7Letters, TheListNamesAllLettersAndTheBridgeCanReadIt) {
  const std::string list = host.ask(request('h'));
  const auto letters = bridges::io7::parse_help(list.substr(0, list.rfind('\n') + 1));
  ASSERT_TRUE(letters) << letters.error().what;
  for (int c = 1; c < 128; ++c) {
    const bool listed = std::string(EB_LETTERS_ALL).find(static_cast<char>(c)) != std::string::npos;
    EXPECT_EQ(letters->has(static_cast<char>(c)), listed) << static_cast<char>(c);
  }
}

TEST_P(Io7Letters, OutputModeSwitchesBetweenTextAndBytes) {
  host.ask(request('O', {0}));
  EXPECT_EQ(host.ask(request('V')), two(740));
  host.ask(request('O', {1}));
  EXPECT_EQ(host.ask(request('V')), std::string("740\r\n") + GetParam().prompt);
}

TEST_P(Io7Letters, TheDemoDrives) {
  host.ask(request('E'));
  EXPECT_EQ(host.board.demos, 1U);
  EXPECT_GT(host.board.pins.duty[0], 0);
  host.wait_ms(1600);
  EXPECT_LT(host.board.pins.duty[0], 0) << "it turns after the straight";
  host.wait_ms(1000);
  EXPECT_EQ(host.board.pins.duty[0], 0);
}

INSTANTIATE_TEST_SUITE_P(Forms, Io7Letters,
                         testing::Values(Form{"AsciiRawMsb", false, false, false, ""},
                                         Form{"AsciiRawLsb", false, false, true, ""},
                                         Form{"AsciiText", false, true, false, ""},
                                         Form{"AsciiTextPrompt", false, true, false, "> "},
                                         Form{"BinaryRawMsb", true, false, false, ""},
                                         Form{"BinaryRawLsb", true, false, true, ""},
                                         Form{"BinaryText", true, true, false, ">"}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Io7Board, LettersThatItLacksDoNothing) {
  BoardUnderTest host;  // the command page only
  host.ask("x 100 0\r");
  host.wait_ms(100);
  EXPECT_EQ(host.board.pins.duty[0], 0);
  EXPECT_EQ(host.board.io7.bad_requests, 1U);
}

TEST(Io7Board, TakesAnyLineEnd) {
  BoardUnderTest host;
  EXPECT_EQ(host.ask("v\rv\nv\r\nv\n\r"), "1.041.041.041.04");
}

TEST(Io7Board, EnterShowsThePrompt) {
  BoardUnderTest host(config_with([](eb_config& config) { config.io7.prompt[0] = '>'; }));
  EXPECT_EQ(host.ask("\r"), "\r\n>");
}

TEST(Io7Board, EchoesWhenTold) {
  BoardUnderTest host(config_with([](eb_config& config) { config.io7.echo = true; }));
  EXPECT_EQ(host.ask("v\r"), "v\r\n1.04");
}

TEST(Io7Board, ArgumentsAfterAnUnknownByteNeverBecomeLetters) {
  BoardUnderTest host(config_with([](eb_config& config) { config.io7.binary = true; }));
  EXPECT_EQ(host.ask("?EEEv"), "");
  EXPECT_EQ(host.board.demos, 0U);
  host.wait_ms(19);
  EXPECT_EQ(host.ask("v"), "") << "the line was not quiet for long enough";
  host.wait_ms(20);
  EXPECT_EQ(host.ask("v"), "1.04");
}

TEST(Io7Board, AHalfSaidBinaryRequestIsDroppedWhenTheLineIsQuiet) {
  BoardUnderTest host(config_with([](eb_config& config) { config.io7.binary = true; }));
  host.ask("m\x01");
  host.wait_ms(20);
  EXPECT_EQ(host.ask("v"), "1.04");
  EXPECT_EQ(host.board.pins.duty[0], 0);
}

}  // namespace
}  // namespace eyebridge::firmware
