#include "eyebridge/mapping/scan_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "beam_table.hpp"
#include "beam_walk.hpp"
#include "polygon_fill.hpp"
#include "scan_notes.hpp"
#include "scan_rays.hpp"

namespace eyebridge::mapping {
namespace {

constexpr double kMostCellsOfBeam = 1 << 20;

bool is_finite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }

}  // namespace

struct ScanMapper::Impl {
  BeamModel model;
  std::optional<BeamTable> table;
  double resolution = 0.0;  // that the table is for
  double per_metre = 0.0;   // cells
  ScanRays rays;
  ScanNotes notes;
  PolygonFill fill;
  // Of the scan at hand.
  std::span<const Vec2> directions;
  std::span<const double> ranges;
  RayFrame frame;

  void set_resolution(double metres);
  [[nodiscard]] double place_of(double range) const {
    return std::max(range - model.bias, 0.0) * per_metre;
  }
  bool set_frame(const OccupancyGrid& grid, Vec2 lower, Vec2 upper, Vec2 from, Cell& corner);
  float draw(const BeamWalk& walk, std::size_t ray);
  float draw_unmet(const BeamWalk& walk, std::size_t ray);
  float draw_all(bool fills);
  Result<void> insert(OccupancyGrid& grid, Vec2 from, double gap);
};

void ScanMapper::Impl::set_resolution(double metres) {
  if (table && resolution == metres) return;
  resolution = metres;
  per_metre = 1.0 / metres;
  table.emplace(model, metres);
}

/// Sets the box for cells between two corners, metres, and where it lies in the grid; false where
/// they lie outside.
bool ScanMapper::Impl::set_frame(const OccupancyGrid& grid, Vec2 lower, Vec2 upper, Vec2 from,
                                 Cell& corner) {
  const GridGeometry& g = grid.geometry();
  const Vec2 first = per_metre * (lower - g.origin);
  const Vec2 last = per_metre * (upper - g.origin);
  if (!(last.x > -1.0 && last.y > -1.0 && first.x < g.columns + 1 && first.y < g.rows + 1)) {
    return false;
  }
  // A cell more on each side, for rounding.
  const auto cut = [](double cell, int count) {
    return static_cast<int>(std::min(std::max(std::floor(cell), 0.0), count - 1.0));
  };
  corner = {cut(first.x - 1.0, g.columns), cut(first.y - 1.0, g.rows)};
  frame.box.columns = cut(last.x + 1.0, g.columns) - corner.column + 1;
  frame.box.rows = cut(last.y + 1.0, g.rows) - corner.row + 1;
  frame.box.stride = ScanNotes::stride_of(frame.box.columns);
  frame.clipped = first.x < 1.0 || first.y < 1.0 || last.x >= g.columns - 1 || last.y >= g.rows - 1;
  const Vec2 shift{static_cast<double>(corner.column), static_cast<double>(corner.row)};
  frame.origin = per_metre * (from - g.origin) - shift;
  frame.column = whole_below(frame.origin.x);
  frame.row = whole_below(frame.origin.y);
  return true;
}

/// Says what a beam out of range does, but for what is filled of it; gives what it says of the
/// sensor's own cell.
float ScanMapper::Impl::draw_unmet(const BeamWalk& walk, std::size_t ray) {
  const double scale = per_metre * walk.share();
  int from = std::max(1, walk.first_at(rays.own_from[ray] * walk.share()));
  int to = walk.first_at(model.max_range * scale);
  int near = 0;
  if (model.min_range > 0.0) near = walk.first_at(model.min_range * scale);
  if (frame.clipped) walk.clip(frame.box, from, to);
  const float evidence = table->crossed_unmet;
  walk.visit(frame.box, std::max(from, near), to,
             [=, out = notes.writer()](std::size_t cell, int) { out.say(cell, evidence); });
  return near <= 0 ? evidence : kNoEvidence;
}

/// The same of one that met something.
float ScanMapper::Impl::draw(const BeamWalk& walk, std::size_t ray) {
  const BeamTable::Blur& blur = table->blur(table->sigma(ranges[ray]));
  const double place = place_of(ranges[ray]) * walk.share();
  const int crossed = walk.first_at(place - blur.reach);
  int from = 1;  // the sensor's own cell, 0, may not be on the walk
  int end = std::max(crossed + blur.cells, from);
  if (frame.clipped) walk.clip(frame.box, from, end);

  const ScanNotes::Writer out = notes.writer();
  const float far = table->crossed;
  float near = far;
  int begin = std::max(from, walk.first_at(rays.own_from[ray] * walk.share()));
  const int to = std::min(crossed, end);
  if (model.fold > 0.0) {
    const int folded = walk.first_at(model.min_range * per_metre * walk.share());
    near = folded > 0 ? table->crossed_near : far;
    walk.visit(frame.box, begin, std::min(folded, to),
               [=](std::size_t cell, int) { out.say(cell, near); });
    begin = std::max(begin, folded);
  }
  walk.visit(frame.box, begin, to, [=](std::size_t cell, int) { out.say(cell, far); });
  const double first = walk.distance(0) - place;
  // In the column of the reading the cell that it lies in counts, which need not be the one that
  // the beam is in at the column's middle.
  const int middle = walk.first_at(place - 0.5);
  const std::size_t exact = walk.index_at(middle, place, frame.box);
  walk.visit(frame.box, std::max(crossed, from), end, [=, &blur](std::size_t cell, int k) {
    out.say(k == middle ? exact : cell, blur.at(first + k));
  });
  return crossed > 0 ? near : blur.at(first);
}

/// All beams; gives what they say of the sensor's own cell.
float ScanMapper::Impl::draw_all(bool fills) {
  // Most of a sweep's many at once, as far as floats are fine enough; then the rest.
  constexpr double kFarthest = 1 << 12;  // cells
  float own = kNoEvidence;
  if (fills && model.max_range * per_metre < kFarthest) {
    own = rays.draw(*table, frame, notes.writer());
  }
  const BeamStart start(frame.origin);
  for (std::size_t i = 0; i < rays.count; ++i) {
    if (rays.kind[i] == ScanRays::kSilent) continue;
    const BeamWalk walk(start, directions[i]);
    own = std::max(own, rays.kind[i] == ScanRays::kMet ? draw(walk, i) : draw_unmet(walk, i));
  }
  return own;
}

/// Takes the scan at hand.
Result<void> ScanMapper::Impl::insert(OccupancyGrid& grid, Vec2 from, double gap) {
  if (directions.size() != ranges.size()) {
    throw std::invalid_argument("scan mapper: expected as many ranges as directions");
  }
  if (!is_finite(from)) return fail(Errc::OutOfRange, "a scan from a place that is not finite");
  if (ranges.empty()) return {};
  set_resolution(grid.geometry().resolution);
  if (!(model.max_range * per_metre + table->max_reach < kMostCellsOfBeam)) {
    return fail(Errc::OutOfRange, "a beam would cross more than 2^20 cells");
  }
  // Near the sensor many beams cross each cell. There the cells between them are filled at once: of
  // two that lie close to each other, all cells between are crossed by one of the two, as far as
  // both go. Those that are filled and those that are said must be said the same of.
  constexpr double kClose = 0.7;  // cells: less than 1 / sqrt(2), so that no cell fits between
  const bool fills = gap > 0.0 && model.fold == 0.0;
  const bool alike = table->crossed_unmet == table->crossed && model.min_range == 0.0;
  const RayModel all{model.max_range, model.out_of_range,         model.bias,
                     per_metre,       fills ? kClose / gap : 0.0, alike};
  if (!rays.set(*table, all, directions, ranges)) {
    return fail(Errc::OutOfRange, "a beam along what is no unit vector");
  }
  const RayExtent& extent = rays.extent;
  if (extent.empty) return {};
  const Vec2 lower = from + resolution * extent.lower;
  const Vec2 upper = from + resolution * extent.upper;
  if (auto covered = grid.cover(lower, upper); !covered) return covered;
  Cell corner;
  if (!set_frame(grid, lower, upper, from, corner)) return {};
  notes.begin(frame.box);
  fill.begin(frame.box);
  // All round the first one comes after the last.
  const bool open = (static_cast<double>(rays.count) + 0.1) * gap < 2 * kPi;
  if (fills) fill.flip(frame.origin, rays.corner_x, rays.corner_y, open);
  const float own = draw_all(fills);
  notes.writer().say(frame.box.index_of(frame.column, frame.row), own);
  notes.apply(grid, corner, fill, table->crossed);
  return {};
}

ScanMapper::ScanMapper(const BeamModel& model) : impl_(std::make_unique<Impl>()) {
  model.check();
  impl_->model = model;
}
ScanMapper::~ScanMapper() = default;
ScanMapper::ScanMapper(ScanMapper&&) noexcept = default;
ScanMapper& ScanMapper::operator=(ScanMapper&&) noexcept = default;

const BeamModel& ScanMapper::model() const { return impl_->model; }

Result<void> ScanMapper::insert(OccupancyGrid& grid, Vec2 origin, std::span<const Vec2> directions,
                                std::span<const double> ranges) {
  impl_->directions = directions;
  impl_->ranges = ranges;
  return impl_->insert(grid, origin, 0.0);
}

Result<void> ScanMapper::insert_sweep(OccupancyGrid& grid, Vec2 origin,
                                      std::span<const Vec2> directions, double gap,
                                      std::span<const double> ranges) {
  impl_->directions = directions;
  impl_->ranges = ranges;
  return impl_->insert(grid, origin, std::abs(gap));
}

}  // namespace eyebridge::mapping
