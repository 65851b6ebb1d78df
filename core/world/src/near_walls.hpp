#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry.hpp"
#include "segment_grid.hpp"

namespace eyebridge::world {

/// Walls that are near a place: indices, and their ends in single precision, a row each; padded to
/// whole registers with indices that occurred.
struct WallList {
  std::span<const std::uint32_t> indices;
  const float* ends =
      nullptr;  ///< Rows of a.x, a.y, b.x, b.y, each `stride` long, seen from `centre`.
  std::size_t stride = 0;
  Vec2 centre;
  double error = 0.0;  ///< Metres by which the floats may be off.
};

/// Which walls are within reach of a place. Remembers what it found: not thread-safe.
///
/// The floor is divided into cells of a sixth of the reach, or up to a third where there would be
/// more than a thousand of them; the list of a cell is made when the first ray starts there, and
/// serves all later ones.
class NearWalls {
 public:
  /// Where more walls than this are near, a walk through a RayGrid is faster.
  static constexpr std::size_t kMost = 200;
  /// Lists of ends are padded to a multiple of it.
  static constexpr std::size_t kPadding = 8;

  /// Where more than `most` walls are near, there is no list.
  explicit NearWalls(std::vector<Segment> segments, std::size_t most = kMost);

  /// Indices of all segments within `reach` metres of `origin`, and of some more; ascending.
  /// Nothing when there are too many, or when too many different reaches have been asked for. Valid
  /// until the next call.
  [[nodiscard]] std::optional<WallList> around(Vec2 origin, double reach);

  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

 private:
  /// The lists for one reach.
  struct Layer {
    double reach = 0.0;
    double cell = 1.0;
    double per_cell = 1.0;
    double error = 0.0;  ///< Of the floats, metres.
    std::size_t columns = 1;
    std::size_t rows = 1;
    std::vector<std::uint32_t> starts;  ///< Cell -> first of its items, kUnknown or kTooMany.
    std::vector<std::uint32_t> items;   ///< Each list begins with its length.
    std::vector<float> ends;            ///< Four for each of `items`, list by list.

    struct Cell {
      std::size_t column, row;
    };
    /// Where a place is, seen from the lower left corner of all.
    [[nodiscard]] std::optional<Cell> cell_of(Vec2 place) const;
  };
  static constexpr std::uint32_t kUnknown = ~std::uint32_t{0};
  static constexpr std::uint32_t kTooMany = kUnknown - 1;
  static constexpr std::size_t kMostLayers = 8;

  Layer* layer_for(double reach);
  std::uint32_t make_list(Layer& layer, Vec2 centre);

  std::vector<Segment> segments_;
  std::size_t most_;
  SegmentGrid grid_;
  Vec2 low_;
  Vec2 high_;  ///< Box around all segments.
  std::vector<Layer> layers_;
};

}  // namespace eyebridge::world
