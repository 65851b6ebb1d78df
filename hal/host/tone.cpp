#include "host/tone.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::uint32_t kRate = 44100;
constexpr double kVolume = 0.33 * 32767;
constexpr double kFade = 0.005;  // seconds

void put(std::vector<std::uint8_t>& out, std::string_view text) {
  out.insert(out.end(), text.begin(), text.end());
}
void put(std::vector<std::uint8_t>& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

}  // namespace

std::vector<std::uint8_t> make_tone(double frequency, double duration) {
  const auto samples = static_cast<std::uint32_t>(std::lround(duration * kRate));
  std::vector<std::uint8_t> wav;
  put(wav, "RIFF");
  put(wav, 36 + 2 * samples, 4);
  put(wav, "WAVEfmt ");
  put(wav, 16, 4);  // bytes that follow
  put(wav, 1, 2);   // PCM
  put(wav, 1, 2);   // channels
  put(wav, kRate, 4);
  put(wav, 2 * kRate, 4);  // bytes per second
  put(wav, 2, 2);          // bytes per sample
  put(wav, 16, 2);         // bits per sample
  put(wav, "data");
  put(wav, 2 * samples, 4);
  for (std::uint32_t i = 0; i < samples; ++i) {
    const double time = static_cast<double>(i) / kRate;
    const double edge = std::min(time, duration - time);
    const double volume = kVolume * std::clamp(edge / kFade, 0.0, 1.0);
    const double value = volume * sin_cos(2 * kPi * frequency * time).sin;
    put(wav, static_cast<std::uint16_t>(std::lround(value)), 2);
  }
  return wav;
}

}  // namespace eyebridge::hal
