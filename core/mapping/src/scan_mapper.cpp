#include "eyebridge/mapping/scan_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "beam_table.hpp"
#include "beam_walk.hpp"

namespace eyebridge::mapping {
namespace {

// What the beams of a scan did to a cell: a later one counts before those ahead of it.
enum Mark : std::uint8_t { kUntouched, kCrossedUnmet, kCrossedNear, kCrossed, kMet };

constexpr double kMostCellsOfBeam = 1 << 20;

/// A beam that says something. Cells are counted as its walk does, lengths are in cells.
struct Beam {
  BeamWalk walk;
  double place = 0.0;                     ///< Of what it met, along the walk's columns.
  const BeamTable::Blur* blur = nullptr;  ///< Null: out of range.
  int from = 0;                           ///< First cell that it crossed and tells of;
  int near = 0;                           ///< the first one beyond the least range;
  int crossed = 0;                        ///< the first one that it may have met something in;
  int end = 0;                            ///< the first one that it says nothing of.
  int low = 1;                            ///< Only cells from here, not the origin's own,
  int high = 0;                           ///< to here, not counted, lie within the box.
};

/// A part of a grid.
struct Box {
  Cell lower;
  int columns = 0;
  int rows = 0;
};

bool is_finite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }

/// Adds `evidence` of its mark to each of `count` cells, within the limits.
void add_marks(const std::uint8_t* marks, float* cells, std::size_t count, const float* evidence,
               float lowest, float highest) {
  const float unmet = evidence[kCrossedUnmet];
  const float near = evidence[kCrossedNear];
  const float crossed = evidence[kCrossed];
  for (std::size_t i = 0; i < count; ++i) {
    const int mark = marks[i];
    float add = mark == kCrossed ? crossed : 0.0F;
    add = mark == kCrossedNear ? near : add;
    add = mark == kCrossedUnmet ? unmet : add;
    const float sum = cells[i] + add;
    const float high = sum < highest ? sum : highest;
    cells[i] = high > lowest ? high : lowest;
  }
}

}  // namespace

struct ScanMapper::Impl {
  BeamModel model;
  std::optional<BeamTable> table;
  double resolution = 0.0;  // that the table is for
  std::vector<Beam> beams;
  std::vector<double> ends;         // of beams, by ray: how far they reach, metres; < 0: no reading
  std::vector<std::uint8_t> marks;  // of the box
  std::vector<float> met;           // evidence of cells of the box marked as kMet
  std::vector<std::size_t> met_cells;

  /// How far the evidence of a beam reaches, metres; less than 0 when it says nothing.
  [[nodiscard]] double end_of(double range) const {
    if (!BeamModel::is_reading(range)) return -1.0;
    if (model.is_out_of_range(range)) return model.max_range;
    // Where the columns are widest, cells reach farther along the beam.
    return std::max(range - model.bias, 0.0) + 1.5 * table->max_reach * resolution;
  }
  void make_beam(Vec2 origin, Vec2 direction, double range);
  void mark_crossed(const Box& box, const Beam& beam, int from, int to, Mark mark);
  void mark_met(std::size_t cell, double offset, const Beam& beam);
  void mark_all(const Box& box, Vec2 origin);
  void apply(OccupancyGrid& grid, const Box& box);
  Result<void> insert(OccupancyGrid& grid, Vec2 origin, std::span<const Vec2> directions,
                      std::span<const double> ranges);
};

void ScanMapper::Impl::make_beam(Vec2 origin, Vec2 direction, double range) {
  Beam beam{BeamWalk(origin, direction)};
  const double scale = beam.walk.share() / resolution;
  beam.near = model.min_range > 0.0 ? beam.walk.first_at(model.min_range * scale) : 0;
  if (model.is_out_of_range(range)) {
    beam.from = beam.near;
    beam.crossed = beam.end = beam.walk.first_at(model.max_range * scale);
  } else {
    beam.blur = &table->blur(table->sigma(range));
    beam.place = std::max(range - model.bias, 0.0) * scale;
    beam.crossed = beam.walk.first_at(beam.place - beam.blur->reach);
    beam.end = beam.walk.first_at(beam.place + beam.blur->reach);
    if (model.fold == 0.0) beam.near = 0;
  }
  beam.high = beam.end;
  beams.push_back(beam);
}

void ScanMapper::Impl::mark_crossed(const Box& box, const Beam& beam, int from, int to, Mark mark) {
  beam.walk.visit(box.columns, std::max(from, beam.low), std::min(to, beam.high),
                  [&](std::size_t cell, int) { marks[cell] = mark; });
}

void ScanMapper::Impl::mark_met(std::size_t cell, double offset, const Beam& beam) {
  const float evidence = beam.blur->at(offset);
  if (marks[cell] != kMet) {
    marks[cell] = kMet;
    met[cell] = evidence;
    met_cells.push_back(cell);
  } else {
    met[cell] = std::max(met[cell], evidence);
  }
}

void ScanMapper::Impl::mark_all(const Box& box, Vec2 origin) {
  // The later ones count before those ahead of them.
  for (const Beam& beam : beams) {
    if (beam.blur == nullptr) mark_crossed(box, beam, beam.from, beam.crossed, kCrossedUnmet);
  }
  for (const Beam& beam : beams) {
    if (beam.blur == nullptr) continue;
    const int near = std::min(beam.near, beam.crossed);
    mark_crossed(box, beam, beam.from, near, kCrossedNear);
    mark_crossed(box, beam, near, beam.crossed, kCrossed);
  }
  const int column = static_cast<int>(std::floor(origin.x));
  const int row = static_cast<int>(std::floor(origin.y));
  const bool inside = column >= 0 && row >= 0 && column < box.columns && row < box.rows;
  const auto own = static_cast<std::size_t>(inside ? row * box.columns + column : 0);
  if (inside) {
    for (const Beam& beam : beams) {
      if (beam.from > 0 || beam.crossed <= 0) continue;
      const Mark mark = beam.blur == nullptr ? kCrossedUnmet
                        : beam.near > 0      ? kCrossedNear
                                             : kCrossed;
      marks[own] = std::max<std::uint8_t>(marks[own], mark);
    }
  }
  for (const Beam& beam : beams) {
    if (beam.blur == nullptr) continue;
    if (inside && beam.crossed <= 0 && beam.end > 0) {
      mark_met(own, beam.walk.distance(0) - beam.place, beam);
    }
    beam.walk.visit(
        box.columns, std::max(beam.crossed, beam.low), std::min(beam.end, beam.high),
        [&](std::size_t cell, int k) { mark_met(cell, beam.walk.distance(k) - beam.place, beam); });
  }
}

void ScanMapper::Impl::apply(OccupancyGrid& grid, const Box& box) {
  const float evidence[] = {0.0F, table->crossed_unmet, table->crossed_near, table->crossed};
  const auto columns = static_cast<std::size_t>(box.columns);
  const float lowest = grid.lowest();
  const float highest = grid.highest();
  float* const cells = grid.edit() + grid.geometry().index_of(box.lower);
  const auto stride = static_cast<std::size_t>(grid.geometry().columns);
  for (std::size_t row = 0; row < static_cast<std::size_t>(box.rows); ++row) {
    add_marks(&marks[row * columns], cells + row * stride, columns, evidence, lowest, highest);
  }
  for (const std::size_t cell : met_cells) {
    float& value = cells[cell / columns * stride + cell % columns];
    value = std::min(std::max(value + met[cell], lowest), highest);
  }
}

Result<void> ScanMapper::Impl::insert(OccupancyGrid& grid, Vec2 origin,
                                      std::span<const Vec2> directions,
                                      std::span<const double> ranges) {
  if (directions.size() != ranges.size()) {
    throw std::invalid_argument("scan mapper: expected as many ranges as directions");
  }
  if (!is_finite(origin)) return fail(Errc::OutOfRange, "a scan from a place that is not finite");
  if (!table || resolution != grid.geometry().resolution) {
    resolution = grid.geometry().resolution;
    table.emplace(model, resolution);
  }
  if (!(model.max_range / resolution + table->max_reach < kMostCellsOfBeam)) {
    return fail(Errc::OutOfRange, "a beam would cross more than 2^20 cells");
  }
  Vec2 lower = origin;
  Vec2 upper = origin;
  bool says_something = false;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!is_finite(directions[i])) {
      return fail(Errc::OutOfRange, "a beam in a direction that is not finite");
    }
    const double end = end_of(ranges[i]);
    if (end < 0.0) continue;
    says_something = true;
    const Vec2 tip = origin + end * directions[i];
    lower = {std::min(lower.x, tip.x), std::min(lower.y, tip.y)};
    upper = {std::max(upper.x, tip.x), std::max(upper.y, tip.y)};
  }
  if (!says_something) return {};
  if (const auto covered = grid.cover(lower, upper); !covered) return covered;

  const GridGeometry& g = grid.geometry();
  const Vec2 first = (lower - g.origin) * (1.0 / g.resolution);
  const Vec2 last = (upper - g.origin) * (1.0 / g.resolution);
  if (!(last.x > -1.0 && last.y > -1.0 && first.x < g.columns + 1 && first.y < g.rows + 1)) {
    return {};
  }
  // A cell more on each side, for rounding.
  const auto cut = [](double cell, int count) {
    return static_cast<int>(std::min(std::max(std::floor(cell), 0.0), count - 1.0));
  };
  const Cell low{cut(first.x - 1.0, g.columns), cut(first.y - 1.0, g.rows)};
  const Cell high{cut(last.x + 1.0, g.columns), cut(last.y + 1.0, g.rows)};
  const Box box{low, high.column - low.column + 1, high.row - low.row + 1};
  const bool clipped =
      first.x < 1.0 || first.y < 1.0 || last.x >= g.columns - 1.0 || last.y >= g.rows - 1.0;
  const Vec2 in_box = (origin - g.origin) * (1.0 / g.resolution) -
                      Vec2{static_cast<double>(low.column), static_cast<double>(low.row)};

  beams.clear();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!BeamModel::is_reading(ranges[i])) continue;
    make_beam(in_box, directions[i], ranges[i]);
    Beam& beam = beams.back();
    if (clipped) beam.walk.clip(box.columns, box.rows, beam.low, beam.high);
  }
  const std::size_t size =
      static_cast<std::size_t>(box.columns) * static_cast<std::size_t>(box.rows);
  marks.assign(size, kUntouched);
  met_cells.clear();
  if (met.size() < size) met.resize(size);
  mark_all(box, in_box);
  apply(grid, box);
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
  return impl_->insert(grid, origin, directions, ranges);
}

Result<void> ScanMapper::insert_sweep(OccupancyGrid& grid, Vec2 origin,
                                      std::span<const Vec2> directions, double gap,
                                      std::span<const double> ranges) {
  static_cast<void>(gap);
  return impl_->insert(grid, origin, directions, ranges);
}

}  // namespace eyebridge::mapping
