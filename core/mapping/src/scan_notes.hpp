#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "beam_table.hpp"
#include "beam_walk.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "polygon_fill.hpp"

namespace eyebridge::mapping {

/// Of the evidence that a cell may have.
struct EvidenceLimits {
  float lowest;
  float highest;
};

/// What is said of the cells of a box, and the cells.
struct TiledRows {
  Box box;
  float* said;
  std::uint8_t* told;
  float* cells;              ///< The first of the box's.
  std::size_t cells_stride;  ///< Between their rows.
};

/// Adds what is said in `rows`, and `filled` of the cells of `fill`, to the cells; forgets it.
void add_evidence(const TiledRows& rows, PolygonFill& fill, float filled,
                  const EvidenceLimits& limits);

/// What the beams of a scan say of the cells of a box, until all have spoken. Of what several say
/// of a cell, that counts which speaks most for an obstacle.
class ScanNotes {
 public:
  static constexpr int kTile = 32;  ///< Cells that are looked through together: 128 bytes.

  /// A copy, which what is written through it does not change.
  struct Writer {
    float* said;         ///< Of cells.
    std::uint8_t* told;  ///< By tile of them: whether anything was said.

    void say(std::size_t cell, float evidence) const {
#if defined(__SSE__)
      // What g++ makes of the line below is a branch, or twice as long.
      _mm_store_ss(said + cell, _mm_max_ss(_mm_load_ss(said + cell), _mm_set_ss(evidence)));
#else
      said[cell] = std::max(said[cell], evidence);
#endif
      told[cell / kTile] = 1;
    }
  };

  /// The stride of a box of so many columns: whole words of a fill.
  static int stride_of(int columns);
  /// For a box with that stride, of which nothing is said, and for the index behind it, which
  /// stands for all cells outside.
  void begin(const Box& box);
  [[nodiscard]] Writer writer() { return {said_.data(), told_.data()}; }
  /// Adds what was said, and `filled` of the cells of `fill`, to the cells of `grid` from `corner`
  /// on, within the grid's limits. Forgets it.
  void apply(OccupancyGrid& grid, Cell corner, PolygonFill& fill, float filled);

 private:
  Box box_;
  std::vector<float> said_;
  std::vector<std::uint8_t> told_;
};

}  // namespace eyebridge::mapping
