#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "beam_walk.hpp"
#include "eyebridge/base/pose.hpp"

namespace eyebridge::mapping {

/// The cells of a box whose middles lie within a polygon, by rows of bits.
///
/// An edge flips all cells of a row to the right of where it crosses the row's middle; flips are
/// kept where they begin, one bit each, and carried on when the row is taken. So a polygon costs
/// what its edges cross, not what it covers.
class PolygonFill {
 public:
  static constexpr int kBits = 64;  ///< Cells of a word.

  /// For a box whose stride is whole words. Nothing is filled yet.
  void begin(const Box& box);
  /// Flips what is within the polygon with corners at `origin` + (x, y), as many of both, cells of
  /// the box; of one that is `open`, `origin` is a corner, too, before the first.
  void flip(Vec2 origin, std::span<const float> x, std::span<const float> y, bool open);
  /// Whether anything may be in a row.
  [[nodiscard]] bool any(int row) const { return row >= lowest_ && row < highest_; }
  /// The cells of word `word` of a row, of which `carry` is at first 0 and then that of the word
  /// before. Forgets them.
  std::uint64_t take(int row, int word, std::uint64_t& carry);

 private:
  void edge(Vec2 from, std::int32_t from_row, Vec2 to, std::int32_t to_row);

  Box box_;
  int words_ = 0;
  std::vector<std::uint64_t> flips_;
  std::vector<std::int32_t> rows_;  // of corners: the first whose middle is above, cut to 0 … rows
  std::vector<std::size_t> crossing_;  // edges that cross the middle of a row, by their ends
  int lowest_ = 0;
  int highest_ = 0;
};

inline std::uint64_t PolygonFill::take(int row, int word, std::uint64_t& carry) {
  std::uint64_t& flips = flips_[static_cast<std::size_t>(row * words_ + word)];
  std::uint64_t inside = flips;
  flips = 0;
  for (int shift = 1; shift < kBits; shift *= 2) inside ^= inside << shift;
  inside ^= carry;
  carry = 0 - (inside >> (kBits - 1));
  return inside;
}

}  // namespace eyebridge::mapping
