#pragma once

#include <cstddef>
#include <cstdint>

namespace eyebridge::world {

/// Pairs of a thing and a ray that it may shorten: found many at once, as bits of a word.
class Pairs {
 public:
  static constexpr std::size_t kRoom = 512;
  /// Rays of a word.
  static constexpr std::size_t kRays = 8;

  /// Bits of a ray.
  static constexpr std::size_t kLanes = 8;

  /// Bit kLanes * ray + lane of `word`: thing `first` + lane, ray kRays * octet + ray. `octet` is 0
  /// or 1, and `first` in every word that is added a multiple of the same number.
  void add(std::uint64_t word, std::size_t first, std::size_t octet) {
    const auto base = static_cast<std::uint32_t>(first << 7U | octet << 6U);
    std::uint32_t* at = codes_ + size_;
    size_ += static_cast<std::size_t>(__builtin_popcountll(word));
    // So many, whether there are or not: nobody can foresee how many there are.
    constexpr std::size_t kUsual = 8;
    do {
      for (std::size_t i = 0; i < kUsual; ++i) {
        // The highest bit hides no other one where none is left.
        *at++ = base | static_cast<std::uint32_t>(__builtin_ctzll(word | std::uint64_t{1} << 63U));
        word &= word - 1;
      }
    } while (word != 0);
  }
  [[nodiscard]] bool is_full() const { return size_ + kMostAdded > kRoom; }
  [[nodiscard]] std::size_t size() const { return size_; }
  void clear() { size_ = 0; }
  /// Repeats a pair until there is a whole number of `lanes`. There is one at least.
  void fill_up(std::size_t lanes) {
    for (std::size_t i = 0; i < lanes - 1; ++i) codes_[size_ + i] = codes_[0];
    size_ = (size_ + lanes - 1) / lanes * lanes;
  }
  [[nodiscard]] std::size_t thing(std::size_t pair) const {
    return (codes_[pair] >> 7U) + codes_[pair] % kLanes;
  }
  [[nodiscard]] std::size_t ray(std::size_t pair) const {
    return codes_[pair] / kLanes % (2 * kRays);
  }

 private:
  static constexpr std::size_t kMostAdded = 72;  // and what is written beyond

  std::size_t size_ = 0;
  std::uint32_t codes_[kRoom + kMostAdded];
};

}  // namespace eyebridge::world
