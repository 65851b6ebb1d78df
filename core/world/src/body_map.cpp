#include "body_map.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::world {
namespace {

constexpr double kBodiesPerCell = 4.0;

}  // namespace

void BodyMap::refresh(const Bodies& bodies) {
  if (version_ == bodies.version()) return;
  version_ = bodies.version();
  const std::size_t count = bodies.size();
  if (count != discs_.size()) {
    discs_.resize(count);
    cells_.resize(count);
    near_.resize(count);
    for (std::vector<float>* row : {&x_, &y_, &r_}) row->assign(count + kBeyond, 0.0F);
    const double cells = static_cast<double>(count) / kBodiesPerCell + 1.0;
    const double cell = std::max(
        {std::sqrt(extent_.x * extent_.y / cells), extent_.x / 1024, extent_.y / 1024, 1e-6});
    per_cell_ = 1.0 / cell;
    columns_ = static_cast<std::size_t>(extent_.x * per_cell_) + 1;
    rows_ = static_cast<std::size_t>(extent_.y * per_cell_) + 1;
  }
  starts_.assign(columns_ * rows_ + 2, 0);
  for (BodyId id = 0; id < count; ++id) {
    if (!bodies.is_there(id)) continue;
    const Vec2 p = bodies.position(id);
    cells_[id] = static_cast<std::uint32_t>(index(p.y, rows_) * columns_ + index(p.x, columns_));
    ++starts_[cells_[id] + 2];
  }
  for (std::size_t c = 2; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
  // Each cell's start stands one place too high until its bodies are in.
  farthest_ = 0.0;
  for (BodyId id = 0; id < count; ++id) {
    if (!bodies.is_there(id)) continue;
    const Vec2 p = bodies.position(id);
    const std::size_t at = starts_[cells_[id] + 1]++;
    discs_[at] = {p.x, p.y, bodies.radius_[id], id};
    x_[at] = static_cast<float>(p.x);
    y_[at] = static_cast<float>(p.y);
    r_[at] = static_cast<float>(bodies.radius_[id]);
    farthest_ = std::max({farthest_, std::fabs(p.x), std::fabs(p.y)});
  }
}

std::span<const Disc> BodyMap::around(Vec2 place, double reach) {
  const double limit = reach * reach;
  std::size_t found = 0;
  each_run(place, reach, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2 away = Vec2{discs_[i].x, discs_[i].y} - place;
      // No branch: nobody can foresee who is near.
      near_[found] = discs_[i];
      found += static_cast<std::size_t>(norm_squared(away) < limit);
    }
  });
  return {near_.data(), found};
}

}  // namespace eyebridge::world
