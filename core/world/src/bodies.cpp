#include "bodies.hpp"

#include <algorithm>

namespace eyebridge::world {

BodyId Bodies::add(BodyShape shape, Vec2 position, Heading heading, double radius, double height,
                   Rgb colour) {
  const BodyId id = static_cast<BodyId>(size());
  ++version_;
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
  next_.push_back(kNoBody);
  previous_.push_back(kNoBody);
  cell_.push_back(0);
  const bool larger = radius > largest_radius_;
  largest_radius_ = std::max(largest_radius_, radius);
  if (size() == kGridFrom || (larger && !heads_.empty())) {
    rebuild_grid();
  } else if (!heads_.empty()) {
    link(id, cell_at(position));
  }
  return id;
}

void Bodies::move_to(BodyId id, Vec2 position) {
  ++version_;
  x_[id] = position.x;
  y_[id] = position.y;
  if (heads_.empty()) return;
  const std::size_t cell = cell_at(position);
  if (cell == cell_[id]) return;
  unlink(id);
  link(id, cell);
}

void Bodies::rebuild_grid() {
  // Cells that a typical query overlaps 2 x 2 of, and never more than 128 x 128 of them.
  const double cell = std::max({5.0 * largest_radius_, extent_.x / 128, extent_.y / 128, 1e-6});
  per_cell_ = 1.0 / cell;
  columns_ = std::clamp<std::size_t>(static_cast<std::size_t>(extent_.x * per_cell_) + 1, 1, 129);
  rows_ = std::clamp<std::size_t>(static_cast<std::size_t>(extent_.y * per_cell_) + 1, 1, 129);
  heads_.assign(columns_ * rows_, kNoBody);
  for (BodyId id = 0; id < size(); ++id) link(id, cell_at(position(id)));
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
