#include "sample.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace eyebridge::robios::classic {
namespace {

using ConstBytes = std::span<const std::uint8_t>;

constexpr std::size_t kLargest = std::size_t{16} << 20;
constexpr std::size_t kWavHead = 44;
constexpr std::uint32_t kMostFrequency = 1'000'000;

// Encodings of AU files.
constexpr std::uint32_t kMuLaw = 1;
constexpr std::uint32_t kLinear8 = 2;

std::uint32_t big_endian(ConstBytes bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | bytes[at + i];
  return value;
}

std::uint32_t little_endian(ConstBytes bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | bytes[at + i];
  return value;
}

bool says(ConstBytes bytes, std::size_t at, std::string_view word) {
  return bytes.size() >= at + word.size() && std::equal(word.begin(), word.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

void put(std::vector<std::uint8_t>& out, std::string_view word) {
  out.insert(out.end(), word.begin(), word.end());
}
void put(std::vector<std::uint8_t>& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

std::vector<std::uint8_t> wav_of(ConstBytes values, std::uint32_t frequency, bool mu_law) {
  const auto size = static_cast<std::uint32_t>(values.size());
  std::vector<std::uint8_t> out;
  put(out, "RIFF");
  put(out, size + static_cast<std::uint32_t>(kWavHead) - 8, 4);
  put(out, "WAVEfmt ");
  put(out, 16, 4);
  put(out, mu_law ? 7 : 1, 2);
  put(out, 1, 2);          // channel
  put(out, frequency, 4);  // values,
  put(out, frequency, 4);  // bytes a second
  put(out, 1, 2);          // byte and
  put(out, 8, 2);          // bits a value
  put(out, "data");
  put(out, size, 4);
  for (const std::uint8_t value : values) {
    // AU counts from the middle, WAV from the bottom.
    out.push_back(static_cast<std::uint8_t>(mu_law ? value : value + 128));
  }
  return out;
}

Result<Sample> read_au(ConstBytes bytes) {
  const std::size_t head = big_endian(bytes, 4);
  const std::size_t size = big_endian(bytes, 8);
  const std::uint32_t encoding = big_endian(bytes, 12);
  const std::uint32_t frequency = big_endian(bytes, 16);
  const std::uint32_t channels = big_endian(bytes, 20);
  if (head < kSampleHead || head > bytes.size() || size > bytes.size() - head) {
    return fail(Errc::OutOfRange, "an AU sample that is shorter than it says");
  }
  if ((encoding != kMuLaw && encoding != kLinear8) || channels != 1 || frequency < 1 ||
      frequency > kMostFrequency) {
    return fail(Errc::OutOfRange,
                fmt::format("an AU sample of encoding {}, {} channels and {} values a second; "
                            "expected 8 bits, linear or mu-law, and one channel",
                            encoding, channels, frequency));
  }
  return Sample{static_cast<int>(frequency),
                wav_of(bytes.subspan(head, size), frequency, encoding == kMuLaw)};
}

Result<Sample> read_wav(ConstBytes bytes) {
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t size = little_endian(bytes, at + 4);
    if (size > bytes.size() - at - 8) break;
    if (says(bytes, at, "fmt ") && size >= 16) {
      const std::uint32_t frequency = little_endian(bytes, at + 12);
      if (frequency < 1 || frequency > kMostFrequency) break;
      return Sample{static_cast<int>(frequency), {bytes.begin(), bytes.end()}};
    }
    at += 8 + size + (size & 1);
  }
  return fail(Errc::OutOfRange, "a WAV sample that does not say how fast it is");
}

}  // namespace

Result<std::size_t> sample_size(ConstBytes head) {
  std::size_t size = 0;
  if (head.size() >= kSampleHead && says(head, 0, "RIFF") && says(head, 8, "WAVE")) {
    size = std::size_t{little_endian(head, 4)} + 8;
  } else if (head.size() >= kSampleHead && says(head, 0, ".snd")) {
    size = std::size_t{big_endian(head, 4)} + big_endian(head, 8);
  } else {
    return fail(Errc::OutOfRange, "this is no sample; expected a WAV, AU or SND file in memory");
  }
  if (size > kLargest) {
    return fail(Errc::OutOfRange, fmt::format("a sample of {} bytes, expected at most 16 MB", size));
  }
  return std::max(size, kSampleHead);
}

Result<Sample> read_sample(ConstBytes bytes) {
  const Result<std::size_t> size = sample_size(bytes.first(std::min(bytes.size(), kSampleHead)));
  if (!size) return tl::unexpected(size.error());
  if (*size > bytes.size()) return fail(Errc::OutOfRange, "a sample that is shorter than it says");
  const ConstBytes all = bytes.first(*size);
  return says(all, 0, "RIFF") ? read_wav(all) : read_au(all);
}

}  // namespace eyebridge::robios::classic
