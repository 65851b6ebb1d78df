#include "sources/frame_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "eyebridge/base/math.hpp"
#include "eyebridge/base/random.hpp"

namespace eyebridge::camera {
namespace {

constexpr std::size_t kTableSize = 1U << 14U;
constexpr unsigned kTableBits = 14;
constexpr int kIndicesPerDraw = 64 / kTableBits;
constexpr double kBlurWidth = 320;  // pixels of a picture that `blur` is given for
constexpr std::uint64_t kExposureStream = 0x6578'706F'7375'7265;
constexpr std::uint64_t kColourStream = 0x636F'6C6F'7572'6564;

std::vector<float> normal_table() {
  Random random(0x6E6F726D616C);
  std::vector<double> draws(kTableSize);
  double sum = 0.0;
  for (double& draw : draws) sum += draw = random.gaussian();
  const double mean = sum / kTableSize;
  double squares = 0.0;
  for (const double draw : draws) squares += (draw - mean) * (draw - mean);
  const double scale = 1.0 / std::sqrt(squares / kTableSize);
  std::vector<float> table;
  table.reserve(kTableSize);
  for (const double draw : draws) table.push_back(static_cast<float>((draw - mean) * scale));
  return table;
}

void add_gaussian(const std::vector<float>& table, float sigma, Random& random, Frame& frame) {
  std::uint64_t bits = 0;
  int left = 0;
  for (std::uint8_t& byte : frame.bytes) {
    if (left == 0) {
      bits = random.bits();
      left = kIndicesPerDraw;
    }
    const float noisy = static_cast<float>(byte) + sigma * table[bits & (kTableSize - 1)];
    byte = static_cast<std::uint8_t>(std::clamp(noisy + 0.5F, 0.0F, 255.0F));
    bits >>= kTableBits;
    --left;
  }
}

void add_salt_and_pepper(double fraction, Random& random, Frame& frame) {
  for (std::size_t at = 0; at + 2 < frame.bytes.size(); at += 3) {
    const double draw = random.uniform();
    if (draw >= fraction) continue;
    const std::uint8_t tone = draw < 0.5 * fraction ? 0 : 255;
    for (std::size_t channel = 0; channel < 3; ++channel) frame.bytes[at + channel] = tone;
  }
}

/// EyeSim's "100s & 1000s": each pixel with probability `fraction` of a colour that is evenly
/// spread.
void add_coloured(double fraction, Random& random, Frame& frame) {
  for (std::size_t at = 0; at + 2 < frame.bytes.size(); at += 3) {
    if (!random.chance(fraction)) continue;
    std::uint64_t bits = random.bits();
    for (std::size_t channel = 0; channel < 3; ++channel, bits >>= 8U) {
      frame.bytes[at + channel] = static_cast<std::uint8_t>(bits & 0xFFU);
    }
  }
}

void expose(double gain, Frame& frame) {
  std::array<std::uint8_t, 256> exposed{};
  for (std::size_t i = 0; i < exposed.size(); ++i) {
    exposed[i] = static_cast<std::uint8_t>(
        std::clamp(std::floor(static_cast<double>(i) * gain + 0.5), 0.0, 255.0));
  }
  for (std::uint8_t& byte : frame.bytes) byte = exposed[byte];
}

}  // namespace

void FrameErrors::apply(const ImageNoise& noise, std::uint64_t moment, Frame& frame) {
  const robot::CameraError& error = noise.error;
  if (error.perfect()) return;
  if (error.blur > 0.0) blur_.apply(error.blur * frame.width / kBlurWidth, frame);
  if (error.exposure != 0.0 || error.exposure_sigma > 0.0) {
    Random random(noise.seed ^ kExposureStream, moment);
    const double flicker = error.exposure_sigma > 0.0 ? random.gaussian() : 0.0;
    expose(exp_of(std::numbers::ln2 * (error.exposure + error.exposure_sigma * flicker)), frame);
  }
  Random random(noise.seed, moment);
  if (error.sigma > 0.0) {
    if (normal_.empty()) normal_ = normal_table();
    add_gaussian(normal_, static_cast<float>(error.sigma), random, frame);
  }
  if (error.salt_and_pepper > 0.0) add_salt_and_pepper(error.salt_and_pepper, random, frame);
  if (error.coloured > 0.0) {
    Random colours(noise.seed ^ kColourStream, moment);
    add_coloured(error.coloured, colours, frame);
  }
}

}  // namespace eyebridge::camera
