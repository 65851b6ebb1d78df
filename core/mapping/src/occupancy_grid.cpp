#include "eyebridge/mapping/occupancy_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "eyebridge/base/math.hpp"

namespace eyebridge::mapping {
namespace {

constexpr double kMostCells = 1 << 30;  // along an axis: so that sums of two fit into an int
constexpr int kLeastRoom = 16;          // cells

[[noreturn]] void refuse(const std::string& text) {
  throw std::invalid_argument("occupancy grid: " + text);
}

void check_settings(const OccupancySettings& s) {
  if (!(s.prior > 0.0 && s.prior < 1.0)) refuse("the prior is not between 0 and 1");
  const double prior = log_odds_of(s.prior);
  if (!(s.lowest < prior && prior < s.highest) || !std::isfinite(s.lowest) ||
      !std::isfinite(s.highest)) {
    refuse("the limits of log-odds do not enclose those of the prior");
  }
  if (!(s.free_below > 0.0 && s.free_below <= s.occupied_above && s.occupied_above < 1.0)) {
    refuse("the thresholds are not 0 < free_below <= occupied_above < 1");
  }
  if (!(s.half_life >= 0.0)) refuse("the half-life is negative");
}

void check_geometry(const GridGeometry& g, std::size_t max_cells) {
  if (!(g.resolution > 0.0) || !std::isfinite(g.resolution)) {
    refuse("the resolution is not a positive number of metres");
  }
  if (!std::isfinite(g.origin.x) || !std::isfinite(g.origin.y)) refuse("the origin is not finite");
  if (g.columns <= 0 || g.rows <= 0) refuse("it has no cells");
  if (g.columns > kMostCells || g.rows > kMostCells || g.size() > max_cells) {
    refuse("it has " + std::to_string(g.columns) + " x " + std::to_string(g.rows) +
           " cells: expected at most " + std::to_string(max_cells));
  }
}

Result<void> no_room(double columns, double rows, std::size_t max_cells) {
  const auto shown = [](double count) {
    return count < 1e15 ? std::to_string(static_cast<long long>(count)) : std::string("1e15");
  };
  return fail(Errc::OutOfRange, "the grid would grow to " + shown(columns) + " x " + shown(rows) +
                                    " cells: expected at most " + std::to_string(max_cells));
}

}  // namespace

double log_odds_of(double probability) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (probability <= 0.0) return -kInfinity;
  if (probability >= 1.0) return kInfinity;
  return log_of(probability / (1.0 - probability));
}

double probability_of(double log_odds) { return 1.0 / (1.0 + exp_of(-log_odds)); }

OccupancyGrid::OccupancyGrid(const GridGeometry& geometry, const OccupancySettings& settings)
    : settings_(settings) {
  check_settings(settings);
  check_geometry(geometry, settings.max_cells);
  anchor_ = geometry.origin;
  prior_ = static_cast<float>(log_odds_of(settings.prior));
  lowest_ = static_cast<float>(settings.lowest);
  highest_ = static_cast<float>(settings.highest);
  occupied_above_ = static_cast<float>(log_odds_of(settings.occupied_above));
  free_below_ = static_cast<float>(log_odds_of(settings.free_below));
  raster_ = Raster<float, SeenCells>(geometry, prior_);
}

float OccupancyGrid::clamped(float log_odds) const {
  return std::min(std::max(log_odds, lowest_), highest_);
}

Cell OccupancyGrid::cell_at(Vec2 point) const {
  const GridGeometry& g = raster_.geometry;
  const double column = std::floor((point.x - g.origin.x) / g.resolution);
  const double row = std::floor((point.y - g.origin.y) / g.resolution);
  // Written so that NaN fails.
  if (!(std::abs(column) < kMostCells && std::abs(row) < kMostCells)) return {-1, -1};
  return {static_cast<int>(column), static_cast<int>(row)};
}

float OccupancyGrid::log_odds(Cell cell) const {
  return raster_.geometry.contains(cell) ? raster_[cell] : prior_;
}

double OccupancyGrid::probability(Cell cell) const { return probability_of(log_odds(cell)); }
double OccupancyGrid::probability(Vec2 point) const { return probability(cell_at(point)); }
CellState OccupancyGrid::state(Vec2 point) const { return state(cell_at(point)); }

Result<void> OccupancyGrid::update(Vec2 point, double probability) {
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
    return fail(Errc::OutOfRange, "evidence at a place that is not finite");
  }
  if (!(probability >= 0.0 && probability <= 1.0)) {
    return fail(Errc::OutOfRange, "evidence with a probability that is not 0 to 1");
  }
  if (auto covered = cover(point, point); !covered) return covered;
  const Cell cell = cell_at(point);
  if (raster_.geometry.contains(cell)) {
    add(cell, static_cast<float>(log_odds_of(probability) - log_odds_of(settings_.prior)));
  }
  return {};
}

void OccupancyGrid::add(Cell cell, float evidence) {
  raster_[cell] = clamped(raster_[cell] + evidence);
  ++revision_;
}

void OccupancyGrid::set_probability(Cell cell, double probability) {
  raster_[cell] = clamped(static_cast<float>(log_odds_of(probability)));
  ++revision_;
}

Result<void> OccupancyGrid::cover(Vec2 lower, Vec2 upper) {
  if (!settings_.growing) return {};
  const GridGeometry& g = raster_.geometry;
  const double left = std::floor((lower.x - g.origin.x) / g.resolution);
  const double below = std::floor((lower.y - g.origin.y) / g.resolution);
  const double right = std::floor((upper.x - g.origin.x) / g.resolution) - (g.columns - 1);
  const double above = std::floor((upper.y - g.origin.y) / g.resolution) - (g.rows - 1);
  if (!std::isfinite(left + below + right + above)) {
    return fail(Errc::OutOfRange, "the grid cannot grow to a place that is not finite");
  }
  if (left >= 0 && below >= 0 && right <= 0 && above <= 0) return {};

  // Cells to add on each side; with room, so that a robot that drives on does not have every scan
  // copy the grid.
  const double needed[] = {std::max(-left, 0.0), std::max(-below, 0.0), std::max(right, 0.0),
                           std::max(above, 0.0)};
  for (const bool with_room : {true, false}) {
    double add[4];
    for (int i = 0; i < 4; ++i) {
      const int size = i % 2 == 0 ? g.columns : g.rows;
      add[i] = needed[i] + (with_room && needed[i] > 0 ? std::max(kLeastRoom, size / 4) : 0);
    }
    const double columns = g.columns + add[0] + add[2];
    const double rows = g.rows + add[1] + add[3];
    const bool fits = columns < kMostCells && rows < kMostCells &&
                      std::abs(shift_.column - add[0]) < kMostCells &&
                      std::abs(shift_.row - add[1]) < kMostCells &&
                      columns * rows <= static_cast<double>(settings_.max_cells);
    if (!fits && with_room) continue;
    if (!fits) return no_room(columns, rows, settings_.max_cells);

    shift_ = {shift_.column - static_cast<int>(add[0]), shift_.row - static_cast<int>(add[1])};
    const Vec2 origin{anchor_.x + shift_.column * g.resolution,
                      anchor_.y + shift_.row * g.resolution};
    Raster<float, SeenCells> larger(
        {origin, g.resolution, static_cast<int>(columns), static_cast<int>(rows)}, prior_);
    for (int row = 0; row < g.rows; ++row) {
      const Cell to{static_cast<int>(add[0]), row + static_cast<int>(add[1])};
      copy_differing({&raster_[{0, row}], static_cast<std::size_t>(g.columns)}, &larger[to]);
    }
    raster_ = std::move(larger);
    ++revision_;
    break;
  }
  return {};
}

void OccupancyGrid::clear() {
  for_blocks_unlike(prior_, raster_.cells,
                    [&](std::span<float> block) { std::ranges::fill(block, prior_); });
  ++revision_;
}

void OccupancyGrid::decay(double seconds) {
  if (!(seconds > 0.0) || settings_.half_life == 0.0) return;
  constexpr double kLn2 = 0.693147180559945309417;
  const auto kept = static_cast<float>(exp_of(-kLn2 * (seconds / settings_.half_life)));
  for_blocks_unlike(prior_, raster_.cells, [&](std::span<float> block) {
    for (float& value : block) value = prior_ + (value - prior_) * kept;
  });
  ++revision_;
}

Raster<CellState> states_of(const OccupancyGrid& grid) {
  Raster<CellState> states(grid.geometry());
  std::ranges::transform(grid.raster().cells, states.cells.begin(),
                         [&](float log_odds) { return grid.state_of(log_odds); });
  return states;
}

Raster<std::uint8_t> cells_in(const OccupancyGrid& grid, std::initializer_list<CellState> states) {
  Raster<std::uint8_t> cells(grid.geometry());
  std::ranges::transform(grid.raster().cells, cells.cells.begin(), [&](float log_odds) {
    return std::ranges::find(states, grid.state_of(log_odds)) != states.end() ? 1 : 0;
  });
  return cells;
}

}  // namespace eyebridge::mapping
