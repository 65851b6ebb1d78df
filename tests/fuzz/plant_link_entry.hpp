#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "board_app.h"
#include "eyebridge/mps2/plant_frame.hpp"

// What the fuzz target of the plant link and the test over its corpus do with one input.
namespace eyebridge::fuzz {

/// What both codecs made of a frame must be the same bytes, and what they accept as outputs must be
/// what a board can do, written the same by the other one.
inline void require_same(const mps2::PlantFrame& ours, const eb_plant_frame& firmwares) {
  std::array<std::uint8_t, EB_PLANT_FRAME> packed{};
  const std::size_t size = eb_plant_pack(&firmwares, packed.data());
  const auto encoded = mps2::encode(ours);
  if (encoded != std::vector<std::uint8_t>(packed.begin(), packed.begin() + size)) std::abort();
  const auto outputs = mps2::decode_outputs(ours);
  if (!outputs) return;
  eb_plant_frame again{};
  eb_plant_outputs(&again, ours.sequence, outputs->elapsed_us, outputs->losses, &outputs->pins);
  if (eb_plant_pack(&again, packed.data()) != size ||
      encoded != std::vector<std::uint8_t>(packed.begin(), packed.begin() + size)) {
    std::abort();
  }
}

/// After an F, the text is kind, sequence, length and payload of frames, whose sync and CRC are
/// right: noise alone seldom is a frame.
inline std::string framed(std::string_view text) {
  std::string bytes;
  while (text.size() > 3) {
    mps2::PlantFrame frame{
        static_cast<mps2::PlantKind>(text[0]), static_cast<std::uint8_t>(text[1]), 0, {}};
    const std::size_t wanted = static_cast<std::uint8_t>(text[2]) % (mps2::kMaxPlantPayload + 1);
    text.remove_prefix(3);
    frame.length = static_cast<std::uint8_t>(std::min(wanted, text.size()));
    std::copy_n(text.begin(), frame.length, frame.payload.begin());
    text.remove_prefix(frame.length);
    for (const std::uint8_t byte : mps2::encode(frame)) bytes += static_cast<char>(byte);
  }
  return bytes;
}

/// The bytes to both parsers, and to the firmware itself, which lets 3 ms pass after each.
inline void plant_link(std::string_view text) {
  const std::string made = text.starts_with('F') ? framed(text.substr(1)) : std::string(text);
  mps2::PlantParser parser;
  eb_plant_parser firmwares{};
  eb_app app;
  eb_app_init(&app);
  for (const char c : made) {
    const auto byte = static_cast<std::uint8_t>(c);
    parser.push(byte);
    eb_plant_push(&firmwares, byte);
    for (;;) {
      const auto frame = parser.next();
      eb_plant_frame other{};
      if (eb_plant_next(&firmwares, &other) != frame.has_value()) std::abort();
      if (!frame) break;
      require_same(*frame, other);
    }
    eb_app_plant(&app, byte);
    eb_app_host(&app, byte);
    eb_app_time(&app, 3000);
    std::array<std::uint8_t, EB_PLANT_FRAME> out{};
    if (eb_app_to_plant(&app, out.data()) > out.size()) std::abort();
    while (eb_app_to_host(&app, out.data(), out.size()) > 0) {
    }
  }
  if (parser.dropped() != firmwares.dropped) std::abort();
}

}  // namespace eyebridge::fuzz
