#include "pose_bins.hpp"

#include <algorithm>
#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge::localisation {
namespace {

constexpr int kBinBits = 21;
constexpr std::int64_t kBinHalf = std::int64_t{1} << (kBinBits - 1);
constexpr std::uint64_t kBinMask = (std::uint64_t{1} << kBinBits) - 1;

std::int64_t bounded_bin(double value) {
  const auto half = static_cast<double>(kBinHalf);
  return static_cast<std::int64_t>(std::clamp(std::floor(value), 1.0 - half, half - 2.0));
}

constexpr std::uint32_t kNoCluster = ~std::uint32_t{0};

}  // namespace

PoseBins::PoseBins(double size, double turn)
    : size_(size), turns_(std::max<std::int64_t>(1, std::llround(2 * kPi / turn))) {}

std::uint64_t PoseBins::key_of(const Place& place) {
  return (static_cast<std::uint64_t>(place.x + kBinHalf) << (2 * kBinBits)) |
         (static_cast<std::uint64_t>(place.y + kBinHalf) << kBinBits) |
         static_cast<std::uint64_t>(place.turn);
}

PoseBins::Place PoseBins::place_of(std::uint64_t key) {
  return {static_cast<std::int64_t>(key >> (2 * kBinBits)) - kBinHalf,
          static_cast<std::int64_t>((key >> kBinBits) & kBinMask) - kBinHalf,
          static_cast<std::int64_t>(key & kBinMask)};
}

std::uint64_t PoseBins::key_of(const Pose& pose) const {
  const auto turns = static_cast<double>(turns_);
  const std::int64_t turn = bounded_bin((wrap_angle(pose.theta) + kPi) / (2 * kPi) * turns);
  return key_of(Place{bounded_bin(pose.x / size_), bounded_bin(pose.y / size_),
                      std::clamp<std::int64_t>(turn, 0, turns_ - 1)});
}

std::size_t PoseBins::count(const Particles& particles, std::span<const std::size_t> chosen) const {
  std::vector<std::uint64_t> keys;
  keys.reserve(chosen.size());
  std::size_t last = ~std::size_t{0};
  for (const std::size_t i : chosen) {  // ascending: copies of one stand together
    if (i != last) keys.push_back(key_of(particles.pose(i)));
    last = i;
  }
  std::sort(keys.begin(), keys.end());
  return static_cast<std::size_t>(std::unique(keys.begin(), keys.end()) - keys.begin());
}

std::vector<std::uint32_t> PoseBins::clusters(const Particles& particles) const {
  std::vector<std::uint64_t> of_particle(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) of_particle[i] = key_of(particles.pose(i));
  std::vector<std::uint64_t> bins = of_particle;
  std::sort(bins.begin(), bins.end());
  bins.erase(std::unique(bins.begin(), bins.end()), bins.end());
  const auto find = [&](std::uint64_t key) {
    return static_cast<std::size_t>(std::lower_bound(bins.begin(), bins.end(), key) - bins.begin());
  };

  std::vector<std::uint32_t> cluster(bins.size(), kNoCluster);
  std::vector<std::size_t> waiting;
  std::uint32_t count = 0;
  for (std::size_t first = 0; first < bins.size(); ++first) {
    if (cluster[first] != kNoCluster) continue;
    cluster[first] = count;
    waiting.assign(1, first);
    while (!waiting.empty()) {
      const Place from = place_of(bins[waiting.back()]);
      waiting.pop_back();
      for (int neighbour = 0; neighbour < 27; ++neighbour) {
        const Place to{from.x + neighbour % 3 - 1, from.y + neighbour / 3 % 3 - 1,
                       (from.turn + neighbour / 9 - 1 + turns_) % turns_};
        const std::uint64_t key = key_of(to);
        const std::size_t at = find(key);
        if (at == bins.size() || bins[at] != key || cluster[at] != kNoCluster) continue;
        cluster[at] = count;
        waiting.push_back(at);
      }
    }
    ++count;
  }

  std::vector<std::uint32_t> out(particles.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = cluster[find(of_particle[i])];
  return out;
}

}  // namespace eyebridge::localisation
