#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <mutex>
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

/// Which walls are within reach of a place. Remembers what it found. Any thread.
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
  ~NearWalls();

  /// Indices of all segments within `reach` metres of `origin`, and of some more; ascending.
  /// Nothing when there are too many, or when more than eight different reaches have been asked
  /// for.
  [[nodiscard]] std::optional<WallList> around(Vec2 origin, double reach) const;

  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

 private:
  struct List;
  /// The lists for one reach.
  struct Layer {
    double reach = 0.0;
    double cell = 1.0;
    double per_cell = 1.0;
    double error = 0.0;  ///< Of the floats, metres.
    std::size_t columns = 1;
    std::size_t rows = 1;
    /// One a cell; null where none was made yet.
    mutable std::vector<std::atomic<const List*>> lists;

    struct Cell {
      std::size_t column, row;
    };
    /// Where a place is, seen from the lower left corner of all.
    [[nodiscard]] std::optional<Cell> cell_of(Vec2 place) const;
  };
  static constexpr std::size_t kMostLayers = 8;

  [[nodiscard]] const Layer* layer_for(double reach) const;
  // making_ is held.
  [[nodiscard]] const List* make_list(const Layer& layer, Vec2 centre) const;

  std::vector<Segment> segments_;
  std::size_t most_;
  SegmentGrid grid_;
  Vec2 low_;
  Vec2 high_;  ///< Box around all segments.
  // What was found. Readers take no lock; a missing list is made under `making_`.
  mutable std::array<std::atomic<Layer*>, kMostLayers> layers_{};
  mutable std::mutex making_;
  mutable std::vector<std::unique_ptr<Layer>> made_layers_;
  mutable std::pmr::monotonic_buffer_resource memory_;  ///< Of the lists.
};

}  // namespace eyebridge::world
