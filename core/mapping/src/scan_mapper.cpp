#include "eyebridge/mapping/scan_mapper.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <vector>

#include "beam_table.hpp"
#include "beam_walk.hpp"

namespace eyebridge::mapping {
namespace {

constexpr double kMostCellsOfBeam = 1 << 20;

bool is_finite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }

// Cells whose evidence is looked through together: 64 bytes of it.
constexpr int kTile = 16;

/// Adds what is said of `count` cells, within the limits, and forgets it.
void add_evidence(float* evidence, float* cells, int count, float lowest, float highest) {
  for (int i = 0; i < count; ++i) {
    const float said = evidence[i];
    evidence[i] = kNoEvidence;
    const float sum = cells[i] + (said > kNoEvidence ? said : 0.0F);
    const float high = sum < highest ? sum : highest;
    cells[i] = high > lowest ? high : lowest;
  }
}

/// Where it is noted what beams say; a copy, which what is written through it does not change.
struct Notes {
  float* said;         ///< Of cells.
  std::uint8_t* told;  ///< By tile of them: whether anything was said.

  /// Of what several beams say of a cell, that counts which speaks most for an obstacle.
  void say(std::size_t cell, float evidence) const {
    const float before = said[cell];
    said[cell] = before > evidence ? before : evidence;
    told[cell / kTile] = 1;
  }
};

}  // namespace

struct ScanMapper::Impl {
  BeamModel model;
  std::optional<BeamTable> table;
  double resolution = 0.0;  // that the table is for
  double per_metre = 0.0;   // cells
  std::vector<float> said;  // of the cells of a box, then of all others; between scans nothing
  std::vector<std::uint8_t> told;  // by tile of these: whether anything was said
  /// A beam that met something.
  struct Met {
    const BeamTable::Blur* blur = nullptr;  ///< Null for all others.
    double place = 0.0;                     ///< Where, cells away.
  };
  std::vector<Met> met;       // by ray
  std::vector<double> clear;  // by ray: how far it crosses cells for sure, cells

  // Of the scan at hand.
  Box box;
  BeamStart start{{}};
  std::size_t own = 0;             // index of the sensor's cell; the box's size when it is outside
  bool clipped = false;            // whether beams may leave the box
  std::array<double, 32> close{};  // by level of beams: as far as the next ones lie close, cells

  void set_resolution(double metres);
  [[nodiscard]] const BeamTable::Blur& blur_of(double range) const {
    return table->blur(table->sigma(range));
  }
  [[nodiscard]] double place_of(double range) const {
    return std::max(range - model.bias, 0.0) * per_metre;
  }
  [[nodiscard]] Notes notes() { return {said.data(), told.data()}; }
  void apply(OccupancyGrid& grid, Cell corner);
  void set_gap(double gap);
  [[nodiscard]] double shared(std::size_t ray) const;
  void draw(const BeamWalk& walk, const Met& beam, double skipped);
  void draw_unmet(const BeamWalk& walk, double skipped);
  Result<void> insert(OccupancyGrid& grid, Vec2 from, std::span<const Vec2> directions, double gap,
                      std::span<const double> ranges);
};

void ScanMapper::Impl::set_resolution(double metres) {
  if (table && resolution == metres) return;
  resolution = metres;
  per_metre = 1.0 / metres;
  table.emplace(model, metres);
}

// Near the sensor many beams cross each cell. There, of two beams that lie close to each other
// the cells of all those between are crossed by one of the two, as far as both go. So every second
// beam begins where its neighbours get too far from each other; of the others, every second where
// those that are left do; and so on.
void ScanMapper::Impl::set_gap(double gap) {
  constexpr double kClose = 0.7;  // cells: less than 1 / sqrt(2), so that no cell fits between
  double apart = gap;
  for (double& distance : close) {
    apart *= 2.0;
    distance = gap > 0.0 ? kClose / apart : 0.0;
  }
}

double ScanMapper::Impl::shared(std::size_t ray) const {
  const int level = std::countr_zero(ray);
  if (ray == 0 || level >= 32) return 0.0;
  const std::size_t apart = std::size_t{1} << level;
  if (ray + apart >= clear.size()) return 0.0;
  const double both = std::min(clear[ray - apart], clear[ray + apart]) - 1.0;
  return std::min(both, close[static_cast<std::size_t>(level)]);
}

/// Says what a beam out of range does.
void ScanMapper::Impl::draw_unmet(const BeamWalk& walk, double skipped) {
  const double scale = per_metre * walk.share();
  int from = std::max(1, walk.first_at(skipped * walk.share()));
  int to = walk.first_at(model.max_range * scale);
  int near = 0;
  if (model.min_range > 0.0) near = walk.first_at(model.min_range * scale);
  if (clipped) walk.clip(box, from, to);
  const float evidence = table->crossed_unmet;
  const auto take = [=, notes = notes()](std::size_t cell, int) { notes.say(cell, evidence); };
  walk.visit(box, std::max(from, near), to, take);
  if (near <= 0) take(own, 0);
}

/// Says what a beam does, but for what others say of cells nearer than `skipped`.
void ScanMapper::Impl::draw(const BeamWalk& walk, const Met& beam, double skipped) {
  const BeamTable::Blur& blur = *beam.blur;
  const double place = beam.place * walk.share();
  const int crossed = walk.first_at(place - blur.reach);
  int from = 1;  // the sensor's own cell, 0, may not be on the walk
  int end = std::max(crossed + blur.cells, from);
  if (clipped) walk.clip(box, from, end);

  const Notes notes = this->notes();
  const float far = table->crossed;
  float near = far;
  int begin = skipped > 1.0 ? std::max(from, walk.first_at(skipped * walk.share())) : from;
  const int to = std::min(crossed, end);
  if (model.fold > 0.0) {
    const int folded = walk.first_at(model.min_range * per_metre * walk.share());
    near = folded > 0 ? table->crossed_near : far;
    walk.visit(box, begin, std::min(folded, to),
               [=](std::size_t cell, int) { notes.say(cell, near); });
    begin = std::max(begin, folded);
  }
  walk.visit(box, begin, to, [=](std::size_t cell, int) { notes.say(cell, far); });
  const double first = walk.distance(0) - place;
  notes.say(own, crossed > 0 ? near : blur.at(first));
  // In the column of the reading the cell that it lies in counts, which need not be the one that
  // the beam is in at the column's middle.
  const int middle = walk.first_at(place - 0.5);
  const std::size_t exact = walk.index_at(middle, place, box);
  walk.visit(box, std::max(crossed, from), end, [=, &blur](std::size_t cell, int k) {
    notes.say(k == middle ? exact : cell, blur.at(first + k));
  });
}

void ScanMapper::Impl::apply(OccupancyGrid& grid, Cell corner) {
  const auto stride = static_cast<std::size_t>(grid.geometry().columns);
  float* const cells = grid.edit() + grid.geometry().index_of(corner);
  const auto width = static_cast<std::size_t>(box.stride) / kTile;
  const std::size_t tiles = box.size() / kTile;
  for (std::size_t first = 0; first < tiles; first += sizeof(std::uint64_t)) {
    std::uint64_t any = 0;  // of eight tiles; there is room for them after the last
    std::memcpy(&any, &told[first], sizeof any);
    if (any == 0) continue;
    for (std::size_t tile = first; tile < std::min(first + sizeof any, tiles); ++tile) {
      if (told[tile] == 0) continue;
      told[tile] = 0;
      const int column = static_cast<int>(tile % width) * kTile;
      add_evidence(&said[tile * kTile], cells + tile / width * stride + column,
                   std::min(kTile, box.columns - column), grid.lowest(), grid.highest());
    }
  }
  said[box.size()] = kNoEvidence;  // of what lay outside
  told[tiles] = 0;
}

Result<void> ScanMapper::Impl::insert(OccupancyGrid& grid, Vec2 from,
                                      std::span<const Vec2> directions, double gap,
                                      std::span<const double> ranges) {
  if (directions.size() != ranges.size()) {
    throw std::invalid_argument("scan mapper: expected as many ranges as directions");
  }
  if (!is_finite(from)) return fail(Errc::OutOfRange, "a scan from a place that is not finite");
  set_resolution(grid.geometry().resolution);
  if (!(model.max_range * per_metre + table->max_reach < kMostCellsOfBeam)) {
    return fail(Errc::OutOfRange, "a beam would cross more than 2^20 cells");
  }
  Vec2 lower = from;
  Vec2 upper = from;
  bool says_something = false;
  clear.assign(ranges.size(), 0.0);
  met.assign(ranges.size(), {});
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!is_finite(directions[i])) {
      return fail(Errc::OutOfRange, "a beam in a direction that is not finite");
    }
    if (!BeamModel::is_reading(ranges[i])) continue;
    says_something = true;
    double end = model.max_range;
    if (!model.is_out_of_range(ranges[i])) {
      // On a diagonal beam a column is sqrt(2) of a cell long.
      met[i] = {&blur_of(ranges[i]), place_of(ranges[i])};
      const double reach = 1.5 * met[i].blur->reach;
      clear[i] = met[i].place - reach;
      end = (met[i].place + reach + 1.5) * resolution;
    }
    const Vec2 tip = from + end * directions[i];
    lower = {std::min(lower.x, tip.x), std::min(lower.y, tip.y)};
    upper = {std::max(upper.x, tip.x), std::max(upper.y, tip.y)};
  }
  if (!says_something) return {};
  if (auto covered = grid.cover(lower, upper); !covered) return covered;

  const GridGeometry& g = grid.geometry();
  const Vec2 first = per_metre * (lower - g.origin);
  const Vec2 last = per_metre * (upper - g.origin);
  if (!(last.x > -1.0 && last.y > -1.0 && first.x < g.columns + 1 && first.y < g.rows + 1)) {
    return {};
  }
  // A cell more on each side, for rounding.
  const auto cut = [](double cell, int count) {
    return static_cast<int>(std::min(std::max(std::floor(cell), 0.0), count - 1.0));
  };
  const Cell corner{cut(first.x - 1.0, g.columns), cut(first.y - 1.0, g.rows)};
  box.columns = cut(last.x + 1.0, g.columns) - corner.column + 1;
  box.rows = cut(last.y + 1.0, g.rows) - corner.row + 1;
  // An odd number of tiles: at a power of two, the cells above each other would fight for the same
  // lines of the cache.
  box.stride = (((box.columns + kTile - 1) / kTile) | 1) * kTile;
  clipped = first.x < 1.0 || first.y < 1.0 || last.x >= g.columns - 1 || last.y >= g.rows - 1;
  const Vec2 shift{static_cast<double>(corner.column), static_cast<double>(corner.row)};
  const Vec2 origin = per_metre * (from - g.origin) - shift;
  start = BeamStart(origin);
  own = box.index_of(whole_below(origin.x), whole_below(origin.y));
  if (said.size() <= box.size()) {
    said.resize(box.size() + 1, kNoEvidence);
    told.resize((box.size() / kTile) + sizeof(std::uint64_t), 0);
  }
  set_gap(gap);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!BeamModel::is_reading(ranges[i])) continue;
    const BeamWalk walk(start, directions[i]);
    if (met[i].blur != nullptr) {
      draw(walk, met[i], shared(i));
    } else {
      draw_unmet(walk, shared(i));
    }
  }
  apply(grid, corner);
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
  return impl_->insert(grid, origin, directions, 0.0, ranges);
}

Result<void> ScanMapper::insert_sweep(OccupancyGrid& grid, Vec2 origin,
                                      std::span<const Vec2> directions, double gap,
                                      std::span<const double> ranges) {
  return impl_->insert(grid, origin, directions, std::abs(gap), ranges);
}

}  // namespace eyebridge::mapping
