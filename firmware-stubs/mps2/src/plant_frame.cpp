#include "eyebridge/mps2/plant_frame.hpp"

#include <algorithm>
#include <bit>
#include <span>
#include <string_view>

namespace eyebridge::mps2 {
namespace {

constexpr std::uint8_t kSync = 0xA5;
constexpr std::size_t kHead = 4;  // sync, kind, sequence, length
constexpr std::size_t kTail = 2;
constexpr std::size_t kOutputsLength = 45;
constexpr std::uint32_t kMostElapsed_us = 100'000;
constexpr std::uint16_t kLongestPulse_us = 2550;

// Bits of the first byte of Config.
enum Flag : std::uint8_t {
  kBinary = 1,
  kVerbose = 2,
  kLsbFirst = 4,
  kPrompt = 8,
  kVwLetters = 16,
};

std::uint16_t crc_of(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xFFFF;
  for (const std::uint8_t byte : bytes) {
    for (int bit = 7; bit >= 0; --bit) {
      const bool carry = ((crc >> 15U) & 1U) != ((byte >> static_cast<unsigned>(bit)) & 1U);
      crc = (crc << 1U & 0xFFFFU) ^ (carry ? 0x1021U : 0U);
    }
  }
  return static_cast<std::uint16_t>(crc);
}

std::uint16_t low_first(std::uint8_t low, std::uint8_t high) {
  return static_cast<std::uint16_t>(low | high << 8);
}

/// Fills a payload from its beginning.
class Writer {
 public:
  Writer(PlantKind kind, std::uint8_t sequence) {
    frame_.kind = kind;
    frame_.sequence = sequence;
  }
  void u8(unsigned value) { frame_.payload.at(frame_.length++) = static_cast<std::uint8_t>(value); }
  void u16(unsigned value) {
    u8(value & 0xFFU);
    u8(value >> 8U & 0xFFU);
  }
  void u32(std::uint32_t value) {
    u16(value & 0xFFFFU);
    u16(value >> 16U);
  }
  void f32(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
  [[nodiscard]] const PlantFrame& frame() const { return frame_; }

 private:
  PlantFrame frame_;
};

/// Reads a payload from its beginning.
class Reader {
 public:
  explicit Reader(const PlantFrame& frame) : frame_(frame) {}
  std::uint8_t u8() { return frame_.payload.at(at_++); }
  std::uint16_t u16() {
    const std::uint8_t low = u8();
    return low_first(low, u8());
  }
  std::uint32_t u32() {
    const std::uint32_t low = u16();
    return low | static_cast<std::uint32_t>(u16()) << 16U;
  }

 private:
  const PlantFrame& frame_;
  std::size_t at_ = 0;
};

bool possible(const PlantOutputs& outputs) {
  const eb_pins& pins = outputs.pins;
  const bool duty = std::ranges::all_of(
      pins.duty, [](int value) { return value >= -EB_DUTY_FULL && value <= EB_DUTY_FULL; });
  const bool pulses =
      std::ranges::all_of(pins.servo_us, [](auto value) { return value <= kLongestPulse_us; });
  const bool ports = (pins.digital_out & ~pins.digital_outputs) == 0;
  return duty && pulses && ports && outputs.elapsed_us > 0 && outputs.elapsed_us <= kMostElapsed_us;
}

}  // namespace

std::vector<std::uint8_t> encode(const PlantFrame& frame) {
  const std::size_t end = kHead + frame.length;
  std::vector<std::uint8_t> bytes(end + kTail);
  bytes[0] = kSync;
  bytes[1] = static_cast<std::uint8_t>(frame.kind);
  bytes[2] = frame.sequence;
  bytes[3] = frame.length;
  std::copy_n(frame.payload.begin(), frame.length, bytes.begin() + kHead);
  const std::uint16_t crc = crc_of(std::span(bytes).first(end).subspan(1));
  bytes[end] = static_cast<std::uint8_t>(crc & 0xFF);
  bytes[end + 1] = static_cast<std::uint8_t>(crc >> 8);
  return bytes;
}

void PlantParser::push(std::uint8_t byte) { bytes_.push_back(byte); }

std::optional<PlantFrame> PlantParser::next() {
  while (!bytes_.empty()) {
    bool good = bytes_[0] == kSync;
    if (good && bytes_.size() < kHead) return {};
    good = good && bytes_[3] <= kMaxPlantPayload;
    if (good) {
      const std::size_t end = kHead + bytes_[3];
      if (bytes_.size() < end + kTail) return {};
      const auto covered = std::span(bytes_).first(end).subspan(1);
      if (crc_of(covered) == low_first(bytes_[end], bytes_[end + 1])) {
        PlantFrame frame{static_cast<PlantKind>(bytes_[1]), bytes_[2], bytes_[3], {}};
        std::copy_n(bytes_.begin() + kHead, frame.length, frame.payload.begin());
        bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(end + kTail));
        return frame;
      }
    }
    bytes_.erase(bytes_.begin());
    ++dropped_;
  }
  return {};
}

std::optional<std::uint8_t> decode_hello(const PlantFrame& frame) {
  if (frame.kind != PlantKind::Hello || frame.length != 1) return {};
  return frame.payload[0];
}

std::optional<PlantOutputs> decode_outputs(const PlantFrame& frame) {
  if (frame.kind != PlantKind::Outputs || frame.length != kOutputsLength) return {};
  Reader in(frame);
  PlantOutputs outputs;
  outputs.elapsed_us = in.u32();
  for (std::int16_t& duty : outputs.pins.duty) duty = static_cast<std::int16_t>(in.u16());
  for (std::uint16_t& pulse : outputs.pins.servo_us) pulse = in.u16();
  outputs.pins.digital_out = in.u16();
  outputs.pins.digital_outputs = in.u16();
  outputs.losses = in.u8();
  if (!possible(outputs)) return {};
  return outputs;
}

PlantFrame encode_config(const eb_config& config) {
  Writer out(PlantKind::Config, 0);
  unsigned flags = 0;
  if (config.io7.binary) flags |= kBinary;
  if (config.io7.verbose) flags |= kVerbose;
  if (config.io7.lsb_first) flags |= kLsbFirst;
  if (config.io7.prompt[0] != 0) flags |= kPrompt;
  const char* letters = config.io7.letters;  // null is the command page
  if (letters != nullptr && std::string_view(letters) == EB_LETTERS_ALL) flags |= kVwLetters;
  out.u8(flags);
  out.u32(config.silence_us);
  out.u32(config.drive.stall_timeout_us);
  for (const float value :
       {config.drive.ticks_per_metre, config.drive.wheel_base, config.drive.max_linear,
        config.drive.max_angular, config.drive.linear_acceleration,
        config.drive.angular_acceleration, config.drive.motor_lag, config.drive.full_ticks}) {
    out.f32(value);
  }
  return out.frame();
}

PlantFrame encode_inputs(std::uint8_t sequence, const eb_pins& pins, std::uint8_t losses) {
  Writer out(PlantKind::Inputs, sequence);
  for (const std::uint16_t counter : pins.encoder) out.u16(counter);
  for (const std::uint16_t raw : pins.psd) out.u16(raw);
  for (const std::uint16_t raw : pins.analog) out.u16(raw);
  out.u16(pins.supply_cv);
  out.u16(pins.digital_in);
  out.u16(pins.digital_driven);
  out.u8(pins.ir_key);
  out.u8(losses);
  return out.frame();
}

}  // namespace eyebridge::mps2
