#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry.hpp"
#include "segment_grid.hpp"

namespace eyebridge::world {

/// Which walls are within reach of a place. Remembers what it found: not thread-safe.
///
/// The floor is divided into cells of an eighth of the reach; the list of a cell is made when the
/// first ray starts there, and serves all later ones.
class NearWalls {
 public:
  /// Where more walls than this are near, a walk through a RayGrid is faster.
  static constexpr std::size_t kMost = 200;

  explicit NearWalls(std::vector<Segment> segments);

  /// Indices of all segments within `reach` metres of `origin`, and of some more; ascending.
  /// Nothing when there are too many, or when too many different reaches have been asked for. Valid
  /// until the next call.
  [[nodiscard]] std::optional<std::span<const std::uint32_t>> around(Vec2 origin, double reach);

  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

 private:
  /// The lists for one reach.
  struct Layer {
    double reach = 0.0;
    double cell = 1.0;
    std::size_t columns = 1;
    std::size_t rows = 1;
    std::vector<std::uint32_t> starts;  ///< Cell -> first of its items, kUnknown or kTooMany.
    std::vector<std::uint32_t> items;   ///< Each list begins with its length.
  };
  static constexpr std::uint32_t kUnknown = ~std::uint32_t{0};
  static constexpr std::uint32_t kTooMany = kUnknown - 1;
  static constexpr std::size_t kMostLayers = 8;

  Layer* layer_for(double reach);
  std::uint32_t make_list(Layer& layer, Vec2 centre);

  std::vector<Segment> segments_;
  SegmentGrid grid_;
  Vec2 low_;
  Vec2 high_;  ///< Box around all segments.
  std::vector<Layer> layers_;
};

}  // namespace eyebridge::world
