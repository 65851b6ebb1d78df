#include "near_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
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

/// The walls near one cell. Its ends and indices follow it in memory, so that the processor fetches
/// all together. Where there are too many walls, `fits` is false.
struct alignas(64) NearWalls::List {
  bool fits = false;
  std::size_t length = 0;
  std::size_t stride = 0;
  Vec2 centre;

  [[nodiscard]] float* ends() { return reinterpret_cast<float*>(this + 1); }
  [[nodiscard]] const float* ends() const { return reinterpret_cast<const float*>(this + 1); }
  [[nodiscard]] const std::uint32_t* indices() const {
    return reinterpret_cast<const std::uint32_t*>(ends() + 4 * stride);
  }
};

NearWalls::~NearWalls() = default;

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

const NearWalls::Layer* NearWalls::layer_for(double reach) const {
  for (const std::atomic<Layer*>& known : layers_) {
    const Layer* const layer = known.load(std::memory_order_acquire);
    if (layer == nullptr) break;
    if (layer->reach == reach) return layer;
  }
  if (layers_.back().load(std::memory_order_acquire) != nullptr) return nullptr;
  const std::lock_guard lock(making_);
  for (const auto& layer : made_layers_) {
    if (layer->reach == reach) return layer.get();
  }
  if (made_layers_.size() == layers_.size()) return nullptr;
  auto made = std::make_unique<Layer>();
  Layer& layer = *made;
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
  layer.lists = std::vector<std::atomic<const List*>>(layer.columns * layer.rows);
  layers_[made_layers_.size()].store(made.get(), std::memory_order_release);
  return made_layers_.emplace_back(std::move(made)).get();
}

const NearWalls::List* NearWalls::make_list(const Layer& layer, Vec2 centre) const {
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
  } else {
    for (std::uint32_t i = 0; i < segments_.size() && i <= most_; ++i) near.push_back(i);
  }
  const bool fits = near.size() <= most_;
  if (!fits) near.clear();
  const std::size_t stride = (near.size() + kPadding - 1) / kPadding * kPadding;
  const std::size_t bytes = sizeof(List) + stride * (4 * sizeof(float) + sizeof(std::uint32_t));
  List& list =
      *new (memory_.allocate(bytes, alignof(List))) List{fits, near.size(), stride, centre};
  float* const ends = list.ends();
  std::fill_n(ends, 4 * stride, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Segment& s = segments_[near[i]];
    const Vec2 a = s.a - centre;
    const Vec2 b = a + s.length * s.u;
    ends[i] = static_cast<float>(a.x);
    ends[stride + i] = static_cast<float>(a.y);
    ends[2 * stride + i] = static_cast<float>(b.x);
    ends[3 * stride + i] = static_cast<float>(b.y);
  }
  near.resize(stride, 0);
  std::ranges::copy(near, const_cast<std::uint32_t*>(list.indices()));
  return &list;
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

std::optional<WallList> NearWalls::around(Vec2 origin, double reach) const {
  if (segments_.empty()) return WallList{};
  const Layer* const layer = layer_for(reach);
  if (layer == nullptr) return std::nullopt;
  const std::optional<Layer::Cell> cell = layer->cell_of(origin - low_);
  if (!cell) return std::nullopt;
  std::atomic<const List*>& known = layer->lists[cell->row * layer->columns + cell->column];
  const List* list = known.load(std::memory_order_acquire);
  if (list == nullptr) {
    const std::lock_guard lock(making_);
    list = known.load(std::memory_order_relaxed);
    if (list == nullptr) {
      list = make_list(*layer, low_ + layer->cell * Vec2{static_cast<double>(cell->column) + 0.5,
                                                         static_cast<double>(cell->row) + 0.5});
      known.store(list, std::memory_order_release);
    }
  }
  if (!list->fits) return std::nullopt;
  return WallList{
      {list->indices(), list->length}, list->ends(), list->stride, list->centre, layer->error};
}

}  // namespace eyebridge::world
