#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "eb_config.h"
#include "eb_pins.h"

namespace eyebridge::mps2 {

// The plant's end of the plant link: what the wires of an emulated board carry, as frames. On the
// wire, in order:
//
//   sync 0xA5 | kind | sequence | length n | payload, n bytes | crc low | crc high
//
// The CRC is CRC-16/CCITT-FALSE (polynomial 0x1021, start 0xFFFF) over kind to payload. Numbers of
// more than a byte are least significant byte first. ../../README.md has the payloads.

inline constexpr std::uint8_t kPlantFormat = 1;  ///< What Hello must say.
inline constexpr std::size_t kMaxPlantPayload = 48;

enum class PlantKind : std::uint8_t {
  Hello = 'H',    ///< Firmware, after a start: what am I?
  Config = 'C',   ///< Plant: the answer; Inputs with sequence 0 follow.
  Outputs = 'O',  ///< Firmware, once a period: this drives the wires, let the world go on.
  Inputs = 'I',   ///< Plant: what is on the wires after that.
};

/// A frame as it was found; whether it makes sense is not known yet.
struct PlantFrame {
  PlantKind kind{};
  std::uint8_t sequence = 0;
  std::uint8_t length = 0;  ///< Bytes of `payload` in use.
  std::array<std::uint8_t, kMaxPlantPayload> payload{};

  friend bool operator==(const PlantFrame&, const PlantFrame&) = default;
};

/// A frame's bytes.
std::vector<std::uint8_t> encode(const PlantFrame& frame);

/// Finds frames in a stream of bytes. Pure: no clock, no I/O.
class PlantParser {
 public:
  /// Takes a byte. next() is to be asked until it has none before the following one.
  void push(std::uint8_t byte);
  /// The next whole frame. Behind a frame that is broken the search goes on from its second byte,
  /// so that the one after it is not lost.
  std::optional<PlantFrame> next();

  /// Bytes that belonged to no frame, since construction.
  [[nodiscard]] std::uint32_t dropped() const { return dropped_; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint32_t dropped_ = 0;
};

/// What Outputs say.
struct PlantOutputs {
  std::uint32_t elapsed_us = 0;  ///< By how much the world is to go on, at most 100 ms.
  std::uint8_t losses = 0;       ///< Of Inputs, as the firmware has last seen it.
  eb_pins pins{};                ///< Its outer side.
};

/// The format that a Hello says; nothing when it is none.
std::optional<std::uint8_t> decode_hello(const PlantFrame& frame);
/// Nothing when it is none, or when it says what no board can do: duty beyond full, pulses above
/// 2.55 ms, levels at ports that are no outputs, no time or more than 100 ms.
std::optional<PlantOutputs> decode_outputs(const PlantFrame& frame);

/// The dialect, the silence and the drive of `config`; the rest of it is the firmware's own.
PlantFrame encode_config(const eb_config& config);
/// The inner side of `pins`. `losses` counts how often the board's host went away.
PlantFrame encode_inputs(std::uint8_t sequence, const eb_pins& pins, std::uint8_t losses);

}  // namespace eyebridge::mps2
