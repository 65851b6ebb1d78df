#include "sources/blur.hpp"

#include <algorithm>
#include <cmath>

#include "eyebridge/base/math.hpp"

namespace eyebridge::camera {
namespace {

constexpr int kChannels = 3;
constexpr unsigned kWeightBits = 14;  // all weights of a row sum up to 2^14
constexpr unsigned kFractionBits = 8;

std::size_t at(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width * kChannels) +
         static_cast<std::size_t>(x * kChannels);
}

}  // namespace

void Blur::set_sigma(double sigma) {
  if (sigma == sigma_) return;
  sigma_ = sigma;
  const int reach = std::max(1, static_cast<int>(std::ceil(3 * sigma)));
  std::vector<double> shape;
  double sum = 0.0;
  for (int i = 0; i <= reach; ++i) {
    shape.push_back(exp_of(-0.5 * i * i / (sigma * sigma)));
    sum += (i == 0 ? 1 : 2) * shape.back();
  }
  weights_.clear();
  std::uint32_t left = 1U << kWeightBits;
  for (const double weight : shape) {
    weights_.push_back(static_cast<std::uint32_t>(std::lround(weight / sum * (1 << kWeightBits))));
  }
  // What rounding took or gave is the middle's, so that an even picture stays as it is.
  for (std::size_t i = 1; i < weights_.size(); ++i) left -= 2 * weights_[i];
  weights_[0] = left;
}

void Blur::apply(double sigma, Frame& frame) {
  set_sigma(sigma);
  const int width = frame.width;
  const int height = frame.height;
  const int reach = static_cast<int>(weights_.size()) - 1;
  rows_.resize(frame.bytes.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int channel = 0; channel < kChannels; ++channel) {
        const auto byte = [&](int column) -> std::uint32_t {
          const int inside = std::clamp(column, 0, width - 1);
          return frame.bytes[at(inside, y, width) + static_cast<std::size_t>(channel)];
        };
        std::uint32_t sum = weights_[0] * byte(x);
        for (int i = 1; i <= reach; ++i) {
          sum += weights_[static_cast<std::size_t>(i)] * (byte(x - i) + byte(x + i));
        }
        rows_[at(x, y, width) + static_cast<std::size_t>(channel)] =
            static_cast<std::uint16_t>(sum >> (kWeightBits - kFractionBits));
      }
    }
  }
  const auto row_bytes = static_cast<std::size_t>(width * kChannels);
  sums_.resize(row_bytes);
  for (int y = 0; y < height; ++y) {
    const auto row = [&](int line) {
      return &rows_[at(0, std::clamp(line, 0, height - 1), width)];
    };
    const std::uint16_t* middle = row(y);
    for (std::size_t i = 0; i < row_bytes; ++i) sums_[i] = weights_[0] * middle[i];
    for (int i = 1; i <= reach; ++i) {
      const std::uint16_t* above = row(y - i);
      const std::uint16_t* below = row(y + i);
      const std::uint32_t weight = weights_[static_cast<std::size_t>(i)];
      for (std::size_t j = 0; j < row_bytes; ++j) {
        sums_[j] += weight * (std::uint32_t{above[j]} + below[j]);
      }
    }
    constexpr std::uint32_t kHalf = 1U << (kWeightBits + kFractionBits - 1);
    std::uint8_t* const out = &frame.bytes[at(0, y, width)];
    for (std::size_t i = 0; i < row_bytes; ++i) {
      out[i] = static_cast<std::uint8_t>((sums_[i] + kHalf) >> (kWeightBits + kFractionBits));
    }
  }
}

}  // namespace eyebridge::camera
