// Both codecs of the plant link against the same bytes, and against each other.
#include "eyebridge/mps2/plant_frame.hpp"

#include <cmath>
#include <cstdlib>
#include <random>

#include <gmock/gmock.h>

#include "golden.hpp"
#include "plant_link.h"

namespace eyebridge::mps2 {
namespace {

using bridges::test::bytes_from_hex;
using Bytes = std::vector<std::uint8_t>;

/// A line of plant.hex.
struct Golden {
  std::string why;
  std::vector<double> numbers;
  Bytes bytes;

  [[nodiscard]] auto u8(std::size_t i) const { return static_cast<std::uint8_t>(numbers.at(i)); }
  [[nodiscard]] auto u16(std::size_t i) const { return static_cast<std::uint16_t>(numbers.at(i)); }
  [[nodiscard]] auto u32(std::size_t i) const { return static_cast<std::uint32_t>(numbers.at(i)); }
  [[nodiscard]] auto f32(std::size_t i) const { return static_cast<float>(numbers.at(i)); }
};

std::vector<Golden> golden(const std::string& kind) {
  std::vector<Golden> found;
  for (const auto& words : bridges::test::golden_lines("plant.hex")) {
    if (words[0] != kind) continue;
    Golden line;
    line.why = words[1];
    std::size_t i = 1;
    for (; words.at(i) != ":"; ++i) line.numbers.push_back(std::strtod(words[i].c_str(), nullptr));
    std::string hex;
    for (++i; i < words.size(); ++i) hex += words[i];
    line.bytes = bytes_from_hex(hex);
    found.push_back(line);
  }
  EXPECT_GE(found.size(), 2u) << kind;
  return found;
}

std::vector<PlantFrame> frames_in(const Bytes& bytes) {
  PlantParser parser;
  std::vector<PlantFrame> found;
  for (const std::uint8_t byte : bytes) {
    parser.push(byte);
    while (const auto frame = parser.next()) found.push_back(*frame);
  }
  return found;
}

/// The same with the firmware's codec.
std::vector<eb_plant_frame> firmware_frames_in(const Bytes& bytes) {
  eb_plant_parser parser{};
  std::vector<eb_plant_frame> found;
  for (const std::uint8_t byte : bytes) {
    eb_plant_push(&parser, byte);
    for (eb_plant_frame frame{}; eb_plant_next(&parser, &frame);) found.push_back(frame);
  }
  return found;
}

Bytes packed(const eb_plant_frame& frame) {
  Bytes bytes(EB_PLANT_FRAME);
  bytes.resize(eb_plant_pack(&frame, bytes.data()));
  return bytes;
}

TEST(PlantFrame, HelloIsWhatTheFirmwareSays) {
  for (const Golden& line : golden("hello")) {
    EXPECT_EQ(decode_hello(frames_in(line.bytes).at(0)), line.u8(0));
  }
  eb_plant_frame hello{};
  eb_plant_hello(&hello);
  EXPECT_EQ(packed(hello), golden("hello").at(0).bytes);
}

TEST(PlantFrame, ConfigTellsTheFirmwareItsDialectAndItsRobot) {
  for (const Golden& line : golden("config")) {
    eb_config config;
    eb_config_default(&config);
    const std::uint8_t flags = line.u8(0);
    config.io7.binary = (flags & 1) != 0;
    config.io7.verbose = (flags & 2) != 0;
    config.io7.lsb_first = (flags & 4) != 0;
    config.io7.prompt[0] = (flags & 8) != 0 ? '>' : '\0';
    config.io7.letters = (flags & 16) != 0 ? EB_LETTERS_ALL : EB_LETTERS_PAGE;
    config.silence_us = line.u32(1);
    config.drive = {line.f32(3), line.f32(4), line.f32(5),  line.f32(6), line.f32(7),
                    line.f32(8), line.f32(9), line.f32(10), line.u32(2)};
    EXPECT_EQ(encode(encode_config(config)), line.bytes);

    eb_config told;
    ASSERT_TRUE(eb_plant_config(&firmware_frames_in(line.bytes).at(0), &told));
    EXPECT_EQ(encode(encode_config(told)), line.bytes);
    EXPECT_STREQ(told.io7.letters, config.io7.letters);
    EXPECT_STREQ(told.io7.prompt, config.io7.prompt);
    EXPECT_EQ(told.drive.wheel_base, config.drive.wheel_base);
    EXPECT_EQ(told.drive.motor_lag, config.drive.motor_lag);
    EXPECT_EQ(told.silence_us, config.silence_us);
  }
}

TEST(PlantFrame, TheFirmwareTakesNoRobotThatItsArithmeticIsNotMadeFor) {
  const float nan = std::nanf("");
  const auto takes = [](float eb_drive_config::*member, float value) {
    eb_config config;
    eb_config_default(&config);
    config.drive.*member = value;
    eb_config told;
    return eb_plant_config(&firmware_frames_in(encode(encode_config(config))).at(0), &told);
  };
  EXPECT_TRUE(takes(&eb_drive_config::motor_lag, 0.5F));
  EXPECT_FALSE(takes(&eb_drive_config::motor_lag, nan));
  EXPECT_FALSE(takes(&eb_drive_config::wheel_base, 0.0F));
  EXPECT_FALSE(takes(&eb_drive_config::wheel_base, nan));
  EXPECT_FALSE(takes(&eb_drive_config::max_linear, -1.0F));
  EXPECT_FALSE(takes(&eb_drive_config::ticks_per_metre, HUGE_VALF));
  EXPECT_FALSE(takes(&eb_drive_config::full_ticks, 32001.0F));
}

TEST(PlantFrame, OutputsCarryWhatTheBoardDrives) {
  for (const Golden& line : golden("outputs")) {
    const PlantFrame frame = frames_in(line.bytes).at(0);
    const auto outputs = decode_outputs(frame);
    ASSERT_TRUE(outputs);
    EXPECT_EQ(frame.sequence, line.u8(0));
    EXPECT_EQ(outputs->elapsed_us, line.u32(1));
    EXPECT_EQ(outputs->losses, line.u8(2));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(outputs->pins.duty[i], line.numbers.at(3 + i));
    for (std::size_t i = 0; i < 14; ++i) EXPECT_EQ(outputs->pins.servo_us[i], line.u16(7 + i));
    EXPECT_EQ(outputs->pins.digital_out, line.u16(21));
    EXPECT_EQ(outputs->pins.digital_outputs, line.u16(22));

    eb_plant_frame made{};
    eb_plant_outputs(&made, line.u8(0), line.u32(1), line.u8(2), &outputs->pins);
    EXPECT_EQ(packed(made), line.bytes);
  }
}

TEST(PlantFrame, InputsCarryWhatTheBoardReads) {
  for (const Golden& line : golden("inputs")) {
    eb_pins pins{};
    for (std::size_t i = 0; i < 4; ++i) pins.encoder[i] = line.u16(2 + i);
    for (std::size_t i = 0; i < 6; ++i) pins.psd[i] = line.u16(6 + i);
    for (std::size_t i = 0; i < 9; ++i) pins.analog[i] = line.u16(12 + i);
    pins.supply_cv = line.u16(21);
    pins.digital_in = line.u16(22);
    pins.digital_driven = line.u16(23);
    pins.ir_key = line.u8(24);
    EXPECT_EQ(encode(encode_inputs(line.u8(0), pins, line.u8(1))), line.bytes);

    eb_pins read{};
    std::uint8_t losses = 0;
    ASSERT_TRUE(eb_plant_inputs(&firmware_frames_in(line.bytes).at(0), &read, &losses));
    EXPECT_EQ(losses, line.u8(1));
    EXPECT_EQ(encode(encode_inputs(line.u8(0), read, losses)), line.bytes);
  }
}

TEST(PlantFrame, ABrokenFrameIsNoneAndTheOneAfterItIsFound) {
  const Bytes good = golden("outputs").at(0).bytes;
  for (const Golden& line : golden("broken")) {
    EXPECT_TRUE(frames_in(line.bytes).empty()) << line.why;
    EXPECT_TRUE(firmware_frames_in(line.bytes).empty()) << line.why;
    Bytes both = line.bytes;
    both.insert(both.end(), good.begin(), good.end());
    both.insert(both.end(), good.begin(), good.end());
    EXPECT_EQ(frames_in(both).size(), 2u) << line.why;
    EXPECT_EQ(firmware_frames_in(both).size(), 2u) << line.why;
  }
}

TEST(PlantFrame, OutputsThatNoBoardCanHaveAreRefused) {
  for (const Golden& line : golden("refused")) {
    const auto frames = frames_in(line.bytes);
    ASSERT_EQ(frames.size(), 1u) << line.why;
    EXPECT_FALSE(decode_outputs(frames[0])) << line.why;
    EXPECT_FALSE(decode_hello(frames[0])) << line.why;
  }
}

TEST(PlantFrame, AFrameOfAnotherKindOrLengthIsNotRead) {
  const eb_plant_frame outputs = firmware_frames_in(golden("outputs").at(0).bytes).at(0);
  eb_config config;
  eb_pins pins{};
  std::uint8_t losses = 7;
  EXPECT_FALSE(eb_plant_config(&outputs, &config));
  EXPECT_FALSE(eb_plant_inputs(&outputs, &pins, &losses));
  for (const char* kind : {"config", "inputs"}) {
    eb_plant_frame cut = firmware_frames_in(golden(kind).at(0).bytes).at(0);
    --cut.length;
    EXPECT_FALSE(eb_plant_config(&cut, &config)) << kind;
    EXPECT_FALSE(eb_plant_inputs(&cut, &pins, &losses)) << kind;
  }
  EXPECT_EQ(losses, 7);
}

TEST(PlantFrame, BothParsersFindTheSameInNoise) {
  std::mt19937 random(20);
  const Bytes good = golden("inputs").at(1).bytes;
  Bytes noise;
  int whole = 0;
  while (noise.size() < 200'000) {
    Bytes piece = good;
    switch (random() % 4) {
      case 0:
        ++whole;
        break;
      case 1:
        piece[random() % piece.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
        break;
      case 2:
        piece.resize(random() % piece.size());
        break;
      default:
        for (std::uint8_t& byte : piece) {
          byte = random() % 3 == 0 ? std::uint8_t{0xA5} : static_cast<std::uint8_t>(random());
        }
    }
    noise.insert(noise.end(), piece.begin(), piece.end());
  }
  const auto ours = frames_in(noise);
  const auto firmwares = firmware_frames_in(noise);
  ASSERT_EQ(ours.size(), firmwares.size());
  int good_ones = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_EQ(encode(ours[i]), packed(firmwares[i]));
    good_ones += encode(ours[i]) == good ? 1 : 0;
  }
  // The last one may still be waiting for the bytes that a broken length before it promised.
  EXPECT_GE(good_ones, whole - 1);
}

}  // namespace
}  // namespace eyebridge::mps2
