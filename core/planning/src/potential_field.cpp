#include "eyebridge/planning/potential_field.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "eyebridge/planning/sight.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;

// Way-points are half a cell apart. Who has come no farther than three cells in a hundred of them
// moves to and fro.
constexpr double kStepCells = 0.5;
constexpr std::size_t kPatience = 100;
constexpr double kProgressCells = 3.0;

// Nearer than this share of a cell the push no longer grows, so that it stays finite.
constexpr double kNearestCells = 0.1;

class Potential {
 public:
  Potential(const ClearanceRaster& clearance, Vec2 goal, const PotentialSettings& settings)
      : clearance_(clearance), goal_(goal), settings_(settings) {}

  [[nodiscard]] double at(Vec2 point) const {
    const double away = norm(point - goal_);
    const double bowl = settings_.bowl;
    const double pull = away <= bowl ? 0.5 * away * away : bowl * away - 0.5 * bowl * bowl;
    const double nearest = kNearestCells * clearance_.geometry.resolution;
    const double room = std::max(between_centres(point), nearest);
    const double push = room < settings_.reach ? 1.0 / room - 1.0 / settings_.reach : 0.0;
    return settings_.attraction * pull + 0.5 * settings_.repulsion * push * push;
  }

  /// Downhill, by differences over a cell: wide enough to see both sides of a ridge of the
  /// clearance, between two walls, at once.
  [[nodiscard]] Vec2 downhill(Vec2 point) const {
    const double half = 0.5 * clearance_.geometry.resolution;
    return {at({point.x - half, point.y}) - at({point.x + half, point.y}),
            at({point.x, point.y - half}) - at({point.x, point.y + half})};
  }

 private:
  /// Clearance between the centres of cells, by bilinear interpolation.
  [[nodiscard]] double between_centres(Vec2 point) const {
    const mapping::GridGeometry& grid = clearance_.geometry;
    const auto place = [&](double along, double origin, int cells) {
      return std::clamp((along - origin) / grid.resolution - 0.5, 0.0, cells - 1.0);
    };
    const double x = place(point.x, grid.origin.x, grid.columns);
    const double y = place(point.y, grid.origin.y, grid.rows);
    const Cell low{static_cast<int>(x), static_cast<int>(y)};
    const Cell high{std::min(low.column + 1, grid.columns - 1),
                    std::min(low.row + 1, grid.rows - 1)};
    const double right = x - low.column;
    const double up = y - low.row;
    const auto room = [&](int column, int row) {
      // Infinite where nothing is blocked; no farther obstacle counts.
      return std::min(static_cast<double>(clearance_[{column, row}]), 2.0 * settings_.reach);
    };
    const double below =
        (1 - right) * room(low.column, low.row) + right * room(high.column, low.row);
    const double above =
        (1 - right) * room(low.column, high.row) + right * room(high.column, high.row);
    return (1 - up) * below + up * above;
  }

  const ClearanceRaster& clearance_;
  Vec2 goal_;
  const PotentialSettings& settings_;
};

void check(const PotentialSettings& settings) {
  const auto positive = [](double value, const char* complaint) {
    if (!(value > 0.0)) throw std::invalid_argument(complaint);
  };
  positive(settings.attraction, "potential field: attraction must be > 0");
  positive(settings.bowl, "potential field: bowl must be > 0");
  positive(settings.reach, "potential field: reach must be > 0");
  positive(settings.steps, "potential field: steps must be > 0");
  if (!(settings.repulsion >= 0.0)) {
    throw std::invalid_argument("potential field: repulsion must be >= 0");
  }
}

}  // namespace

Planned follow_potential(const BlockedRaster& blocked, const ClearanceRaster& clearance, Vec2 start,
                         Vec2 goal, const PotentialSettings& settings) {
  check(settings);
  assert(clearance.geometry == blocked.geometry);
  const tl::expected<Ends, NoPath> ends = ends_of(blocked, start, goal);
  if (!ends) return tl::unexpected(ends.error());
  const Potential potential(clearance, goal, settings);
  const double cell = blocked.geometry.resolution;
  const double step = kStepCells * cell;
  Path path;
  path.points.push_back(start);
  for (int i = 0; i < settings.steps; ++i) {
    const Vec2 at = path.points.back();
    if (norm(goal - at) <= step && is_free_line(blocked, at, goal)) {
      path.points.push_back(goal);
      path.length = length_of(path.points);
      path.expanded = path.points.size() - 1;
      return path;
    }
    const std::size_t count = path.points.size();
    if (count > kPatience &&
        norm(at - path.points[count - 1 - kPatience]) < kProgressCells * cell) {
      return tl::unexpected(NoPath::LocalMinimum);
    }
    const Vec2 downhill = potential.downhill(at);
    const double slope = norm(downhill);
    if (slope == 0.0) return tl::unexpected(NoPath::LocalMinimum);
    const Vec2 next = at + step / slope * downhill;
    if (!is_free_line(blocked, at, next)) return tl::unexpected(NoPath::LocalMinimum);
    path.points.push_back(next);
  }
  return tl::unexpected(NoPath::BudgetSpent);
}

}  // namespace eyebridge::planning
