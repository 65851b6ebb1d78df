#include "host/sound_length.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace eyebridge::hal {
namespace {

using Bytes = std::span<const std::uint8_t>;

bool starts_with(Bytes bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::equal(text.begin(), text.end(), bytes.begin());
}

std::uint32_t little_endian(Bytes bytes) {
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U |
         static_cast<std::uint32_t>(bytes[2]) << 16U | static_cast<std::uint32_t>(bytes[3]) << 24U;
}

/// Chunks: a name of 4 bytes, a length of 4, that many bytes, and one more where that is odd.
std::optional<double> wav_length(Bytes bytes) {
  constexpr std::size_t kHead = 8;
  constexpr std::size_t kRateAt = 8;  // of the bytes per second in "fmt "
  std::optional<double> rate;
  Bytes rest = bytes.subspan(std::min<std::size_t>(12, bytes.size()));
  while (rest.size() >= kHead) {
    const std::size_t length = little_endian(rest.subspan(4, 4));
    const Bytes body = rest.subspan(kHead, std::min(length, rest.size() - kHead));
    if (starts_with(rest, "fmt ") && body.size() >= kRateAt + 4) {
      rate = little_endian(body.subspan(kRateAt, 4));
    }
    if (starts_with(rest, "data") && rate && *rate > 0) {
      return static_cast<double>(body.size()) / *rate;
    }
    rest = rest.subspan(std::min(rest.size(), kHead + body.size() + length % 2));
  }
  return std::nullopt;
}

struct Mp3Frame {
  std::size_t bytes = 0;
  double seconds = 0.0;
};

/// ISO/IEC 11172-3 and 13818-3, the header of a frame of layer III; 2.5 is Fraunhofer's.
std::optional<Mp3Frame> mp3_frame(Bytes bytes) {
  constexpr std::array<int, 16> kRates1 = {0,   32,  40,  48,  56,  64,  80,  96,
                                           112, 128, 160, 192, 224, 256, 320, 0};  // kbit/s
  constexpr std::array<int, 16> kRates2 = {0,  8,  16, 24,  32,  40,  48,  56,
                                           64, 80, 96, 112, 128, 144, 160, 0};
  constexpr std::array<int, 4> kSampling = {44100, 48000, 32000, 0};  // hertz
  if (bytes.size() < 4 || bytes[0] != 0xFF || (bytes[1] & 0xE0) != 0xE0) return std::nullopt;
  const unsigned version = bytes[1] >> 3U & 3U;  // 0: 2.5, 2: 2, 3: 1
  const unsigned layer = bytes[1] >> 1U & 3U;    // 1: III
  if (version == 1 || layer != 1) return std::nullopt;
  const bool first = version == 3;
  const int kilobits = (first ? kRates1 : kRates2).at(bytes[2] >> 4U);
  const int sampling = kSampling.at(bytes[2] >> 2U & 3U) / (first ? 1 : version == 2 ? 2 : 4);
  if (kilobits == 0 || sampling == 0) return std::nullopt;
  const int samples = first ? 1152 : 576;
  const int padding = bytes[2] >> 1U & 1;
  return Mp3Frame{static_cast<std::size_t>(samples / 8 * kilobits * 1000 / sampling + padding),
                  static_cast<double>(samples) / sampling};
}

/// "ID3", version (2 bytes), flags, and the length in 7 bits a byte.
Bytes without_tag(Bytes bytes) {
  if (!starts_with(bytes, "ID3") || bytes.size() < 10) return bytes;
  std::size_t length = 10;
  std::size_t body = 0;
  for (const std::uint8_t byte : bytes.subspan(6, 4)) body = body << 7U | (byte & 0x7FU);
  length += body;
  return bytes.subspan(std::min(length, bytes.size()));
}

std::optional<double> mp3_length(Bytes bytes) {
  double seconds = 0.0;
  Bytes rest = without_tag(bytes);
  // Two bytes in a row look like a frame by chance: the first one has to be followed by another.
  bool in_step = false;
  while (rest.size() >= 4) {
    const auto frame = mp3_frame(rest);
    const bool ends = frame && frame->bytes >= rest.size();
    if (!frame || (!in_step && !ends && !mp3_frame(rest.subspan(frame->bytes)))) {
      in_step = false;
      rest = rest.subspan(1);
      continue;
    }
    in_step = true;
    seconds += frame->seconds;
    rest = rest.subspan(std::min(frame->bytes, rest.size()));
  }
  if (seconds > 0.0) return seconds;
  return std::nullopt;
}

}  // namespace

Result<SoundFacts> read_sound(std::span<const std::uint8_t> bytes) {
  if (starts_with(bytes, "RIFF") && bytes.size() >= 12 && starts_with(bytes.subspan(8), "WAVE")) {
    if (const auto length = wav_length(bytes)) return SoundFacts{SoundFormat::Wav, *length};
    return fail(Errc::Unsupported, "a WAV file without sound, expected its chunks fmt and data");
  }
  if (const auto length = mp3_length(bytes)) return SoundFacts{SoundFormat::Mp3, *length};
  return fail(Errc::Unsupported, "no sound that is known, expected WAV or MP3");
}

}  // namespace eyebridge::hal
