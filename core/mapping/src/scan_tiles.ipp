// Adds tiles of evidence to cells, some of them in one register. Included as scan_place.ipp is.

namespace {

constexpr int kTileLanes = EYEBRIDGE_TILE_LANES;
using TileLanes = float __attribute__((vector_size(4 * kTileLanes)));
using TileBits = std::int32_t __attribute__((vector_size(4 * kTileLanes)));

EYEBRIDGE_RAY_TARGET inline TileLanes larger(TileLanes a, TileLanes b) {
#if defined(__x86_64__) && EYEBRIDGE_TILE_LANES == 8
  return __builtin_ia32_maxps256(a, b);
#elif defined(__x86_64__) && EYEBRIDGE_TILE_LANES == 4
  return __builtin_ia32_maxps(a, b);
#else
  return a > b ? a : b;
#endif
}

EYEBRIDGE_RAY_TARGET inline TileLanes smaller(TileLanes a, TileLanes b) {
#if defined(__x86_64__) && EYEBRIDGE_TILE_LANES == 8
  return __builtin_ia32_minps256(a, b);
#elif defined(__x86_64__) && EYEBRIDGE_TILE_LANES == 4
  return __builtin_ia32_minps(a, b);
#else
  return a < b ? a : b;
#endif
}

EYEBRIDGE_RAY_TARGET inline TileLanes load(const float* from) {
  TileLanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

EYEBRIDGE_RAY_TARGET inline void store(float* to, TileLanes lanes) {
  std::memcpy(to, &lanes, sizeof lanes);
}

/// All lanes the same.
EYEBRIDGE_RAY_TARGET inline TileLanes all(float value) { return TileLanes{} + value; }

/// What is the same for all tiles, in registers.
struct TileSum {
  TileLanes none;
  TileLanes filled;
  TileLanes lowest;
  TileLanes highest;
};

/// Adds evidence to cells, within the limits.
EYEBRIDGE_RAY_TARGET inline void add_lanes(float* cells, const TileLanes& added,
                                           const TileSum& all_tiles) {
  const TileLanes sum = load(cells) + added;
  store(cells, larger(smaller(sum, all_tiles.highest), all_tiles.lowest));
}

/// A tile of which something may be said, and of which the cells `inside`, by bits, are filled.
EYEBRIDGE_RAY_TARGET inline void add_tile(float* said, std::uint32_t inside, float* cells,
                                          const TileSum& all_tiles) {
#if EYEBRIDGE_TILE_LANES == 8
  const TileBits bits{1, 2, 4, 8, 16, 32, 64, 128};
#else
  const TileBits bits{1, 2, 4, 8};
#endif
  for (int i = 0; i < ScanNotes::kTile; i += kTileLanes) {
    const TileBits chosen = TileBits{} + static_cast<std::int32_t>(inside >> i);
    const TileBits is_filled = (chosen & bits) == bits;
    const TileLanes most = larger(load(said + i), is_filled ? all_tiles.filled : all_tiles.none);
    store(said + i, all_tiles.none);
    add_lanes(cells + i, (TileLanes)((TileBits)most & (TileBits)(most > all_tiles.none)),
              all_tiles);
  }
}

/// Cells that are filled, and of which nothing else is said.
EYEBRIDGE_RAY_TARGET inline void add_filled(float* cells, int count, const TileSum& all_tiles) {
  for (int i = 0; i < count; i += kTileLanes) add_lanes(cells + i, all_tiles.filled, all_tiles);
}

/// A tile of which only `count` cells are of the box.
EYEBRIDGE_RAY_TARGET inline void add_end(float* said, std::uint32_t inside, float* cells, int count,
                                         const TileSum& all_tiles) {
  std::array<float, ScanNotes::kTile> end{};
  std::copy_n(cells, count, end.begin());
  add_tile(said, inside, end.data(), all_tiles);
  std::copy_n(end.begin(), count, cells);
}

EYEBRIDGE_RAY_TARGET void apply_tiles(const TiledRows& rows, PolygonFill& fill, float filled,
                                      const EvidenceLimits& limits) {
  constexpr int kTile = ScanNotes::kTile;
  constexpr int kWord = PolygonFill::kBits;
  constexpr std::uint32_t kWhole = static_cast<std::uint32_t>((std::uint64_t{1} << kTile) - 1);
  const TileSum all_tiles{all(kNoEvidence), all(filled), all(limits.lowest), all(limits.highest)};
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
