#include "near_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace eyebridge::world {
namespace {

/// The lists of a layer cover at most this many cells in a row.
constexpr double kMostListCells = 1024;

constexpr double kMostCellsInReach = 6.0;
constexpr double kFewestCellsInReach = 3.0;
/// The lists of so many cells stay in a processor's second cache.
constexpr double kUsualCells = 1024.0;

}  // namespace

NearWalls::NearWalls(std::vector<Segment> segments, std::size_t most)
    : segments_(std::move(segments)),
      most_(most),
      grid_(segments_, cell_size_for(segments_, 1.0), 0) {
  if (segments_.empty()) return;
  low_ = high_ = segments_.front().a;
  for (const Segment& s : segments_) {
    for (const Vec2 p : {s.a, s.a + s.length * s.u}) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }
}

NearWalls::Layer* NearWalls::layer_for(double reach) {
  for (Layer& layer : layers_) {
    if (layer.reach == reach) return &layer;
  }
  if (layers_.size() == kMostLayers) return nullptr;
  Layer& layer = layers_.emplace_back();
  layer.reach = reach;
  const Vec2 extent = high_ - low_;
  const double size = std::max(extent.x, extent.y);
  // An endless reach sees the same from everywhere.
  const double wanted = std::clamp(std::sqrt(extent.x * extent.y / kUsualCells),
                                   reach / kMostCellsInReach, reach / kFewestCellsInReach);
  layer.cell = std::max({std::min(wanted, size), size / kMostListCells, 1e-3});
  layer.per_cell = 1.0 / layer.cell;
  layer.error = 1e-4 + 1e-6 * (extent.x + extent.y);
  layer.columns = static_cast<std::size_t>(extent.x / layer.cell) + 1;
  layer.rows = static_cast<std::size_t>(extent.y / layer.cell) + 1;
  layer.starts.assign(layer.columns * layer.rows, kUnknown);
  return &layer;
}

std::uint32_t NearWalls::make_list(Layer& layer, Vec2 centre) {
  // From the farthest corner of the cell; more than rounding makes of a place.
  const double limit = layer.reach + 0.5 * std::sqrt(2.0) * layer.cell * (1.0 + 1e-6) + 1e-6;
  std::vector<std::uint32_t> near;
  if (limit * limit < std::numeric_limits<double>::max()) {
    grid_.each_in_box(centre - Vec2{limit, limit}, centre + Vec2{limit, limit},
                      [&](std::uint32_t i) {
                        const Vec2 away = closest_point(segments_[i], centre) - centre;
                        if (norm_squared(away) <= limit * limit) near.push_back(i);
                      });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  } else if (segments_.size() <= most_) {
    for (std::uint32_t i = 0; i < segments_.size(); ++i) near.push_back(i);
  } else {
    return kTooMany;
  }
  if (near.size() > most_) return kTooMany;
  const auto start = static_cast<std::uint32_t>(layer.items.size());
  layer.items.push_back(static_cast<std::uint32_t>(near.size()));
  layer.items.insert(layer.items.end(), near.begin(), near.end());
  // Where item i stands, its floats begin at 4 i: padded lists fill whole registers.
  const std::size_t stride = (near.size() + kPadding - 1) / kPadding * kPadding;
  layer.items.resize(start + std::max(stride, near.size() + 1), 0);
  layer.ends.resize(4 * layer.items.size(), std::numeric_limits<float>::quiet_NaN());
  float* const ends = layer.ends.data() + 4 * std::size_t{start};
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Segment& s = segments_[near[i]];
    const Vec2 a = s.a - centre;
    const Vec2 b = a + s.length * s.u;
    ends[i] = static_cast<float>(a.x);
    ends[stride + i] = static_cast<float>(a.y);
    ends[2 * stride + i] = static_cast<float>(b.x);
    ends[3 * stride + i] = static_cast<float>(b.y);
  }
  return start;
}

std::optional<NearWalls::Layer::Cell> NearWalls::Layer::cell_of(Vec2 place) const {
  const double x = place.x * per_cell;
  const double y = place.y * per_cell;
  // Also false for NaN.
  const bool there =
      x >= 0.0 && y >= 0.0 && x < static_cast<double>(columns) && y < static_cast<double>(rows);
  if (!there) return std::nullopt;
  return Cell{static_cast<std::size_t>(x), static_cast<std::size_t>(y)};
}

std::optional<WallList> NearWalls::around(Vec2 origin, double reach) {
  if (segments_.empty()) return WallList{};
  Layer* const layer = layer_for(reach);
  if (layer == nullptr) return std::nullopt;
  const std::optional<Layer::Cell> cell = layer->cell_of(origin - low_);
  if (!cell) return std::nullopt;
  std::uint32_t& start = layer->starts[cell->row * layer->columns + cell->column];
  const Vec2 centre = low_ + layer->cell * Vec2{static_cast<double>(cell->column) + 0.5,
                                                static_cast<double>(cell->row) + 0.5};
  if (start == kUnknown) start = make_list(*layer, centre);
  if (start == kTooMany) return std::nullopt;
  const std::size_t length = layer->items[start];
  return WallList{{layer->items.data() + start + 1, length},
                  layer->ends.data() + 4 * std::size_t{start},
                  (length + kPadding - 1) / kPadding * kPadding,
                  centre,
                  layer->error};
}

}  // namespace eyebridge::world
