#include "bodies.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace eyebridge::world {
namespace {

/// In a row of the grid.
constexpr double kMostCells = 2048;

/// How far around them bodies look, in cells of the grid.
constexpr double kHorizonCells = 0.35;

}  // namespace

BodyId Bodies::add(BodyShape shape, Vec2 position, Heading heading, double radius, double height,
                   Rgb colour) {
  const BodyId id = static_cast<BodyId>(size());
  ++version_;
  ++epoch_;
  freedom_.emplace_back();
  x_.push_back(position.x);
  y_.push_back(position.y);
  vx_.push_back(0.0);
  vy_.push_back(0.0);
  cos_.push_back(heading.cos);
  sin_.push_back(heading.sin);
  radius_.push_back(radius);
  height_.push_back(height);
  clearance_.push_back(0.0);
  hold_.emplace_back();
  shape_.push_back(shape);
  colour_.push_back(colour);
  response_.emplace_back();
  outline_.emplace_back();
  next_.push_back(kNoBody);
  previous_.push_back(kNoBody);
  cell_.push_back(0);
  const bool larger = radius > largest_radius_;
  largest_radius_ = std::max(largest_radius_, radius);
  // Twice as many bodies get half as large cells.
  const bool crowded = size() >= kGridFrom && std::has_single_bit(size());
  if (crowded || (larger && !heads_.empty())) {
    rebuild_grid();
  } else if (!heads_.empty()) {
    link(id, cell_at(position));
  }
  return id;
}

void Bodies::rebuild_grid() {
  // A body has few others in its cell, and looks into few cells to find all near it.
  const double cells = 2.0 * static_cast<double>(size());
  const double cell = std::max({5.0 * largest_radius_, std::sqrt(extent_.x * extent_.y / cells),
                                extent_.x / kMostCells, extent_.y / kMostCells, 1e-6});
  per_cell_ = 1.0 / cell;
  horizon_ = kHorizonCells * cell;
  columns_ = static_cast<std::size_t>(extent_.x * per_cell_) + 1;
  rows_ = static_cast<std::size_t>(extent_.y * per_cell_) + 1;
  heads_.assign(columns_ * rows_, kNoBody);
  for (BodyId id = 0; id < size(); ++id) {
    if (is_there(id)) link(id, cell_at(position(id)));
  }
}

void Bodies::remove(BodyId id) {
  if (!is_there(id)) return;
  ++version_;
  ++epoch_;
  if (heads_.empty()) rebuild_grid();  // from now on it says who is there
  unlink(id);
  cell_[id] = kNoCell;
}

void Bodies::link(BodyId id, std::size_t cell) {
  cell_[id] = cell;
  previous_[id] = kNoBody;
  next_[id] = heads_[cell];
  if (next_[id] != kNoBody) previous_[next_[id]] = id;
  heads_[cell] = id;
}

void Bodies::unlink(BodyId id) {
  if (previous_[id] == kNoBody) {
    heads_[cell_[id]] = next_[id];
  } else {
    next_[previous_[id]] = next_[id];
  }
  if (next_[id] != kNoBody) previous_[next_[id]] = previous_[id];
}

}  // namespace eyebridge::world
