#include "render/noise.hpp"

#include <algorithm>
#include <cmath>

#include "eyebridge/base/random.hpp"

namespace eyebridge::camera {
namespace {

constexpr std::size_t kTableSize = 1U << 14U;
constexpr unsigned kTableBits = 14;
constexpr int kIndicesPerDraw = 64 / kTableBits;

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

}  // namespace

void NoiseMaker::apply(const ImageNoise& noise, Frame& frame) {
  // By time: the sequence begins again with every source that is opened.
  Random random(noise.seed, static_cast<std::uint64_t>(frame.time.count()));
  if (noise.error.sigma > 0.0) {
    if (normal_.empty()) normal_ = normal_table();
    add_gaussian(normal_, static_cast<float>(noise.error.sigma), random, frame);
  }
  if (noise.error.salt_and_pepper > 0.0) {
    add_salt_and_pepper(noise.error.salt_and_pepper, random, frame);
  }
}

}  // namespace eyebridge::camera
