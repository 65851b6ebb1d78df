#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/mapping/raster.hpp"
#include "eyebridge/mapping/seen_cells.hpp"

namespace eyebridge::mapping {

/// Most cells of a map, unless more are asked for: 160 x 160 m with cells of 2 cm.
inline constexpr std::size_t kMostMapCells = std::size_t{1} << 26U;

/// What is held of a cell.
enum class CellState : std::uint8_t { Unknown, Free, Occupied };

/// Settings of an OccupancyGrid. Probabilities are 0 … 1, log-odds are ln(p / (1 - p)).
struct OccupancySettings {
  double prior = 0.5;            ///< Of a cell of which nothing is known; within (0, 1).
  double lowest = -5.0;          ///< Log-odds never sink below this, nor
  double highest = 5.0;          ///< rise above this: so that a belief can change its mind.
  double occupied_above = 0.65;  ///< More probable is CellState::Occupied: ROS's default.
  double free_below = 0.196;     ///< Less probable is CellState::Free: ROS's default.
  bool growing = false;          ///< Whether evidence beyond the bounds moves them.
  std::size_t max_cells = kMostMapCells;  ///< No grid has more.
  double half_life = 0.0;  ///< Seconds in which decay() halves what is known; 0: never forgets.

  friend bool operator==(const OccupancySettings&, const OccupancySettings&) = default;
};

/// How probable it is that something stands in each cell of a floor.
///
/// Belief and truth are the same class: a robot's belief takes evidence by update(), a map that was
/// made from a world or read from a file has what set_probability() put there. Cells are taken as
/// independent, and evidence is added as log-odds (Moravec and Elfes, "High Resolution Maps from
/// Wide Angle Sonar", ICRA 1985; Thrun, Burgard and Fox, "Probabilistic Robotics", 2005, table
/// 9.1). With a prior of 0.5 it takes memory only for what has been seen. Not thread-safe. The
/// values stay where they are in memory as long as the bounds do.
class OccupancyGrid {
 public:
  /// Every cell at the prior. Throws std::invalid_argument for settings or a geometry that cannot
  /// be: a resolution that is not positive and finite, no cells, more than `max_cells`.
  explicit OccupancyGrid(const GridGeometry& geometry, const OccupancySettings& settings = {});

  [[nodiscard]] const GridGeometry& geometry() const { return raster_.geometry; }
  [[nodiscard]] const OccupancySettings& settings() const { return settings_; }
  /// Log-odds of all cells, in row order from the lower left one: what a view without a copy shows.
  [[nodiscard]] const Raster<float, SeenCells>& raster() const { return raster_; }
  /// Counts changes of values or bounds: who draws the grid does so again when this has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  /// Log-odds; the prior's where the grid does not reach.
  [[nodiscard]] float log_odds(Cell cell) const;
  /// Probability that `cell` is occupied; the prior where the grid does not reach.
  [[nodiscard]] double probability(Cell cell) const;
  /// The same of the cell that `point` lies in; the prior for a point that is not finite.
  [[nodiscard]] double probability(Vec2 point) const;
  [[nodiscard]] CellState state(Cell cell) const { return state_of(log_odds(cell)); }
  [[nodiscard]] CellState state(Vec2 point) const;
  /// By the two thresholds of the settings.
  [[nodiscard]] CellState state_of(float log_odds) const {
    if (log_odds > occupied_above_) return CellState::Occupied;
    return log_odds < free_below_ ? CellState::Free : CellState::Unknown;
  }
  /// The cell that `point` lies in, or one outside of every grid, when the point is not finite or
  /// too far away for any.
  [[nodiscard]] Cell cell_at(Vec2 point) const;

  /// Takes evidence: `probability` of the cell given one reading, by its inverse sensor model.
  ///
  /// Beyond the bounds of a grid that does not grow nothing happens. Fails with OutOfRange, and
  /// changes nothing, for a point that is not finite, a probability outside of [0, 1] and where
  /// the grid would need more than `max_cells`.
  Result<void> update(Vec2 point, double probability);
  /// Adds evidence, log-odds of a reading less those of the prior, to a cell of the grid.
  void add(Cell cell, float evidence);
  /// Makes a cell of the grid as probable as `probability`, 0 … 1, as far as the limits of
  /// log-odds let it.
  void set_probability(Cell cell, double probability);

  /// Moves the bounds so that they cover the rectangle; with some room, when they have to move.
  /// Nothing happens in a grid that does not grow. Fails, and changes nothing, as update() does.
  Result<void> cover(Vec2 lower, Vec2 upper);
  /// Everything back to the prior; the bounds stay.
  void clear();
  /// Lets `seconds` >= 0 pass: what is known fades towards the prior by the settings' half-life.
  void decay(double seconds);

  /// All values, to be changed within the settings' limits; counts as a change.
  [[nodiscard]] float* edit() {
    ++revision_;
    return raster_.cells.data();
  }
  [[nodiscard]] float lowest() const { return lowest_; }
  [[nodiscard]] float highest() const { return highest_; }
  [[nodiscard]] float prior() const { return prior_; }  ///< Log-odds.

 private:
  [[nodiscard]] float clamped(float log_odds) const;

  OccupancySettings settings_;
  Raster<float, SeenCells> raster_;
  Vec2 anchor_;  // the corner that the grid began with: no rounding adds up when it grows
  Cell shift_;   // of the corner it has now, from there
  float prior_ = 0.0F;
  float lowest_ = 0.0F;
  float highest_ = 0.0F;
  float occupied_above_ = 0.0F;
  float free_below_ = 0.0F;
  std::uint64_t revision_ = 0;
};

/// What is held of each cell.
Raster<CellState> states_of(const OccupancyGrid& grid);
/// 1 where a cell is held to be in one of `states`, else 0.
Raster<std::uint8_t> cells_in(const OccupancyGrid& grid, std::initializer_list<CellState> states);

/// ln(p / (1 - p)); infinite for 0 and 1. `probability` is 0 … 1.
double log_odds_of(double probability);
/// The probability with these log-odds.
double probability_of(double log_odds);

}  // namespace eyebridge::mapping
