#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "eyebridge/localisation/scan_matcher.hpp"
#include "eyebridge/mapping/distance_field.hpp"

namespace eyebridge::localisation {
namespace {

// Standard deviations from which on a hit counts for nothing: 2e-8.
constexpr double kNoScore = 6.0;

constexpr double kMostShifts = 1000;  // to each side

const MatchSettings& checked_match(const MatchSettings& s, double resolution) {
  const bool good = s.window > 0.0 && s.turn_window > 0.0 && s.turn_window <= kPi &&
                    s.sigma > 0.0 && s.least_score >= 0.0 && s.least_score <= 1.0 && s.block > 0 &&
                    s.rounds >= 0 && s.window <= kMostShifts * resolution;
  if (!good) throw std::invalid_argument("scan matching: settings out of range");
  return s;
}

/// Of each value and the `count` - 1 that follow it every `step`, the largest.
void slide_maximum(std::vector<float>& table, std::size_t step, int count) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    float most = table[i];
    for (int k = 1; k < count; ++k) {
      const std::size_t other = i + static_cast<std::size_t>(k) * step;
      if (other < table.size()) most = std::max(most, table[other]);
    }
    table[i] = most;
  }
}

double sum_at(const std::vector<float>& table, const std::vector<std::int32_t>& places,
              std::int32_t shift) {
  const float* const shifted = table.data() + shift;
  double sum = 0.0;
  for (const std::int32_t place : places) sum += static_cast<double>(shifted[place]);
  return sum;
}

/// Shifts from (column, row) on, `block` to each side, at one turn.
struct Block {
  double bound;
  int turn;
  int column;
  int row;
};

/// Of all turns of the window, the nearest to the middle first: equals are settled so.
int nth_from_middle(int n) { return n % 2 == 0 ? n / 2 : -(n + 1) / 2; }

}  // namespace

ScanMatcher::ScanMatcher(const mapping::Raster<std::uint8_t>& occupied,
                         const MatchSettings& settings)
    : distances_(mapping::distance_field(occupied)),
      settings_(checked_match(settings, occupied.geometry.resolution)),
      shifts_(static_cast<int>(std::ceil(settings.window / occupied.geometry.resolution - 1e-9))),
      // Hits are held at the first cell from which no shift leads into the map.
      padding_(2 * shifts_ + settings.block + 1),
      stride_(occupied.geometry.columns + 2 * padding_) {
  const mapping::GridGeometry& where = occupied.geometry;
  const auto rows = static_cast<std::size_t>(where.rows + 2 * padding_);
  score_.assign(static_cast<std::size_t>(stride_) * rows, 0.0F);
  for (int row = 0; row < where.rows; ++row) {
    for (int column = 0; column < where.columns; ++column) {
      const double z = distances_[{column, row}] / settings.sigma;
      if (z > kNoScore) continue;
      score_[static_cast<std::size_t>((row + padding_) * stride_ + column + padding_)] =
          static_cast<float>(exp_of(-0.5 * z * z));
    }
  }
  bound_ = score_;
  slide_maximum(bound_, 1, settings.block);
  slide_maximum(bound_, static_cast<std::size_t>(stride_), settings.block);
}

std::vector<std::int32_t> ScanMatcher::places_of(const Pose& pose, const Scan& scan) const {
  const mapping::GridGeometry& where = distances_.geometry;
  const Heading heading = Heading::from_angle(pose.theta);
  const double beyond = shifts_ + 1;
  const auto held = [&](double cells, int count) {
    return static_cast<int>(std::clamp(std::floor(cells), -beyond, count + beyond - 1));
  };
  std::vector<std::int32_t> places;
  places.reserve(scan.hits.size());
  for (const Vec2 hit : scan.hits) {
    const Vec2 end = pose.position() + heading.rotate(hit) - where.origin;
    const int column = held(end.x / where.resolution, where.columns);
    const int row = held(end.y / where.resolution, where.rows);
    places.push_back((row + padding_) * stride_ + column + padding_);
  }
  return places;
}

Pose ScanMatcher::search(const Pose& guess, const Scan& scan) const {
  double farthest = distances_.geometry.resolution;
  for (const Vec2 hit : scan.hits) farthest = std::max(farthest, norm(hit));
  // What is farther away than the map is wide is not on it, however it is turned.
  const mapping::GridGeometry& where = distances_.geometry;
  const Vec2 extent{where.columns * where.resolution, where.rows * where.resolution};
  farthest = std::min(farthest, norm(extent) + settings_.window);
  const int turns = static_cast<int>(
      std::ceil(settings_.turn_window * farthest / distances_.geometry.resolution));
  const double turn_step = settings_.turn_window / turns;

  std::vector<std::vector<std::int32_t>> places;
  std::vector<Block> blocks;
  for (int n = 0; n <= 2 * turns; ++n) {
    const double theta = guess.theta + nth_from_middle(n) * turn_step;
    places.push_back(places_of({guess.x, guess.y, theta}, scan));
    for (int row = -shifts_; row <= shifts_; row += settings_.block) {
      for (int column = -shifts_; column <= shifts_; column += settings_.block) {
        const double bound = sum_at(bound_, places.back(), row * stride_ + column);
        blocks.push_back({bound, n, column, row});
      }
    }
  }
  std::stable_sort(blocks.begin(), blocks.end(),
                   [](const Block& a, const Block& b) { return a.bound > b.bound; });

  struct Best {
    double score = -1.0;
    int turn = 0;
    int column = 0;
    int row = 0;

    /// Of equals the one nearer to the guess, whatever the size of blocks.
    [[nodiscard]] bool less_than(double other, int n, int x, int y) const {
      if (other != score) return other > score;
      const int far = column * column + row * row;
      const int near = x * x + y * y;
      if (n != turn) return n < turn;
      if (near != far) return near < far;
      return y != row ? y < row : x < column;
    }
  } best;
  for (const Block& block : blocks) {
    if (block.bound < best.score) break;
    const auto& hits = places[static_cast<std::size_t>(block.turn)];
    const int last_row = std::min(block.row + settings_.block - 1, shifts_);
    const int last_column = std::min(block.column + settings_.block - 1, shifts_);
    for (int row = block.row; row <= last_row; ++row) {
      for (int column = block.column; column <= last_column; ++column) {
        const double score = sum_at(score_, hits, row * stride_ + column);
        if (best.less_than(score, block.turn, column, row)) best = {score, block.turn, column, row};
      }
    }
  }
  const double cell = distances_.geometry.resolution;
  return {guess.x + best.column * cell, guess.y + best.row * cell,
          wrap_angle(guess.theta + nth_from_middle(best.turn) * turn_step)};
}

}  // namespace eyebridge::localisation
