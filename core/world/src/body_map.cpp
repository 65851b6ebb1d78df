#include "body_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eyebridge::world {
namespace {

constexpr double kBodiesPerCell = 4.0;  // that is as wide as high
/// Narrow cells: a row of them is one run of bodies, however many they are.
constexpr double kColumnsPerRow = 4.0;

}  // namespace

void BodyMap::refresh(const Bodies& bodies) {
  if (version_ == bodies.version()) return;
  version_ = bodies.version();
  if (bodies.size() != places_.size()) {
    ids_.clear();
    for (BodyId id = 0; id < bodies.size(); ++id) {
      if (!bodies.is_convex(id)) ids_.push_back(id);
    }
    const std::size_t count = ids_.size();
    discs_.resize(count + kBeyond, {0.0, 0.0, std::numeric_limits<double>::quiet_NaN(), kNoBody});
    places_.assign(bodies.size(), where_nobody_is());
    near_.resize(count);
    for (std::vector<float>* row : {&x_, &y_, &r_}) row->assign(count + kBeyond, 0.0F);
    const double cells = static_cast<double>(count) / kBodiesPerCell + 1.0;
    const double cell = std::max(
        {std::sqrt(extent_.x * extent_.y / cells), extent_.x / 1024, extent_.y / 1024, 1e-6});
    per_column_ = kColumnsPerRow / cell;
    per_row_ = 1.0 / cell;
    columns_ = static_cast<std::size_t>(extent_.x * per_column_) + 1;
    rows_ = static_cast<std::size_t>(extent_.y * per_row_) + 1;
  }
  starts_.assign(columns_ * rows_ + 2, 0);
  // At first each body's cell.
  for (const BodyId id : ids_) {
    if (!bodies.is_there(id)) continue;
    const Vec2 p = bodies.position(id);
    places_[id] = static_cast<std::uint32_t>(row_of(p.y) * columns_ + column_of(p.x));
    ++starts_[places_[id] + 2];
  }
  for (std::size_t c = 2; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
  // Each cell's start stands one place too high until its bodies are in.
  farthest_ = 0.0;
  for (const BodyId id : ids_) {
    if (!bodies.is_there(id)) {
      places_[id] = where_nobody_is();
      continue;
    }
    const Vec2 p = bodies.position(id);
    const std::uint32_t at = starts_[places_[id] + 1]++;
    places_[id] = at;
    discs_[at] = {p.x, p.y, bodies.radius_[id], id};
    x_[at] = static_cast<float>(p.x);
    y_[at] = static_cast<float>(p.y);
    r_[at] = static_cast<float>(bodies.radius_[id]);
    farthest_ = std::max({farthest_, std::fabs(p.x), std::fabs(p.y)});
  }
  const std::size_t there = starts_.back();
  for (std::size_t i = there; i < there + kBeyond; ++i) {
    r_[i] = std::numeric_limits<float>::quiet_NaN();
  }
}

std::span<const Disc> BodyMap::around(Vec2 place, double reach) {
  const double limit = reach * reach;
  std::size_t found = 0;
  const Box cells = box(place - Vec2{reach, reach}, place + Vec2{reach, reach});
  for (std::size_t row = cells.first_row; row <= cells.last_row; ++row) {
    for (std::size_t i = begin_of(cells, row); i < end_of(cells, row); ++i) {
      const Vec2 away = Vec2{discs_[i].x, discs_[i].y} - place;
      // No branch: nobody can foresee who is near.
      near_[found] = discs_[i];
      found += static_cast<std::size_t>(norm_squared(away) < limit);
    }
  }
  return {near_.data(), found};
}

}  // namespace eyebridge::world
