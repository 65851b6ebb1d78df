// Adds tiles of evidence to cells, some of them in one register.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "eyebridge/base/instruction_sets.hpp"
#include "polygon_fill.hpp"
#include "scan_notes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scan_tiles.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace eyebridge::mapping::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::ScalableTag<float> kFloat;
constexpr hn::RebindToSigned<decltype(kFloat)> kInt;
constexpr int kLanes = hn::MaxLanes(kFloat);
using Floats = hn::Vec<decltype(kFloat)>;

/// What is the same for all tiles, in registers.
struct TileSum {
  Floats none, filled, lowest, highest;
};

/// Adds evidence to cells, within the limits.
HWY_INLINE void add_lanes(float* cells, Floats added, const TileSum& all_tiles) {
  const Floats sum = hn::LoadU(kFloat, cells) + added;
  const Floats limited = hn::Max(hn::Min(sum, all_tiles.highest), all_tiles.lowest);
  hn::StoreU(limited, kFloat, cells);
}

/// A tile of which something may be said, and of which the cells `inside`, by bits, are filled.
HWY_INLINE void add_tile(float* said, std::uint32_t inside, float* cells,
                         const TileSum& all_tiles) {
  alignas(32) static constexpr std::int32_t kBits[] = {1, 2, 4, 8, 16, 32, 64, 128};
  const auto bits = hn::Load(kInt, kBits);
  for (int i = 0; i < ScanNotes::kTile; i += kLanes) {
    const auto chosen = hn::Set(kInt, static_cast<std::int32_t>(inside >> i));
    const auto is_filled = hn::RebindMask(kFloat, hn::TestBit(chosen, bits));
    const Floats filled = hn::IfThenElse(is_filled, all_tiles.filled, all_tiles.none);
    const Floats most = hn::Max(hn::LoadU(kFloat, said + i), filled);
    hn::StoreU(all_tiles.none, kFloat, said + i);
    add_lanes(cells + i, hn::IfThenElseZero(most > all_tiles.none, most), all_tiles);
  }
}

/// Cells that are filled, and of which nothing else is said.
inline void add_filled(float* cells, int count, const TileSum& all_tiles) {
  for (int i = 0; i < count; i += kLanes) add_lanes(cells + i, all_tiles.filled, all_tiles);
}

/// A tile of which only `count` cells are of the box.
inline void add_end(float* said, std::uint32_t inside, float* cells, int count,
                    const TileSum& all_tiles) {
  std::array<float, ScanNotes::kTile> end{};
  std::copy_n(cells, count, end.begin());
  add_tile(said, inside, end.data(), all_tiles);
  std::copy_n(end.begin(), count, cells);
}

void apply_tiles(const TiledRows& rows, PolygonFill& fill, float filled,
                 const EvidenceLimits& limits) {
  constexpr int kTile = ScanNotes::kTile;
  constexpr int kWord = PolygonFill::kBits;
  constexpr std::uint32_t kWhole = static_cast<std::uint32_t>((std::uint64_t{1} << kTile) - 1);
  const TileSum all_tiles{hn::Set(kFloat, kNoEvidence), hn::Set(kFloat, filled),
                          hn::Set(kFloat, limits.lowest), hn::Set(kFloat, limits.highest)};
  const int columns = rows.box.columns;
  std::uint8_t* row_told = rows.told;
  float* row_said = rows.said;
  float* row_cells = rows.cells;
  for (int row = 0; row < rows.box.rows; ++row) {
    std::uint64_t carry = 0;
    const bool any_filled = fill.any(row);
    for (int word = 0; word < columns; word += kWord) {
      std::uint64_t inside = any_filled ? fill.take(row, word / kWord, carry) : 0;
      std::array<std::uint8_t, kWord / kTile> told{};
      std::memcpy(told.data(), row_told + word / kTile, sizeof told);
      if (told != decltype(told){}) {
        std::memset(row_told + word / kTile, 0, sizeof told);
      } else {
        if (inside == 0) continue;
        if (inside == ~std::uint64_t{0} && word + kWord <= columns) {
          add_filled(row_cells + word, kWord, all_tiles);
          continue;
        }
      }
      const int end = std::min(word + kWord, columns);
      for (int first = word; first < end; first += kTile, inside >>= kTile) {
        const auto here = static_cast<std::uint32_t>(inside) & kWhole;
        const bool is_told = told[static_cast<std::size_t>((first - word) / kTile)] != 0;
        float* const said = row_said + first;
        float* const cells = row_cells + first;
        if (first + kTile > end) {
          add_end(said, here, cells, end - first, all_tiles);
        } else if (is_told || (here != 0 && here != kWhole)) {
          add_tile(said, here, cells, all_tiles);
        } else if (here != 0) {
          add_filled(cells, kTile, all_tiles);
        }
      }
    }
    row_cells += rows.cells_stride;
    row_told += rows.box.stride / kTile;
    row_said += rows.box.stride;
  }
}

}  // namespace
}  // namespace eyebridge::mapping::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyebridge::mapping {

void add_evidence(const TiledRows& rows, PolygonFill& fill, float filled,
                  const EvidenceLimits& limits) {
  EYEBRIDGE_BEST(apply_tiles)(rows, fill, filled, limits);
}

}  // namespace eyebridge::mapping
#endif
