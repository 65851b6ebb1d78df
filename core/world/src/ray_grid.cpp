#include "ray_grid.hpp"

#include <cmath>

#include "ray_query.hpp"

namespace eyebridge::world {
namespace {

/// Fewer segments to a cell mean more cells on the way. Flat around the optimum in mazes and in
/// open scenes (bench_ray_casting).
constexpr double kSegmentsPerCell = 1.6;

/// Rounding of single precision, times the number of roundings on the way to a comparison, with
/// something to spare: of coordinates up to the grid's size, metres per metre.
constexpr double kFloatMargin = 2e-6;

unsigned candidates_in(const RayBlock& block, const RayQuery& q) {
  unsigned lanes = 0;
  for (std::size_t i = 0; i < RayBlock::kLanes; ++i) {
    const float wx = block.ax[i] - q.x;
    const float wy = block.ay[i] - q.y;
    const float den = q.dx * block.uy[i] - q.dy * block.ux[i];
    const float along_ray = wx * block.uy[i] - wy * block.ux[i];
    const float along_wall = wx * q.dy - wy * q.dx;
    const bool flip = std::signbit(den);
    const float size = flip ? -den : den;
    const float r = flip ? -along_ray : along_ray;
    const float w = flip ? -along_wall : along_wall;
    const bool hit = (r >= -q.margin) & (r <= q.reach * size + q.margin) & (w >= -q.margin) &
                     (w <= block.length[i] * size + q.margin);
    lanes |= static_cast<unsigned>(hit) << i;
  }
  return lanes;
}

}  // namespace

RayGrid::RayGrid(const std::vector<Segment>& segments)
    : segments_(segments), grid_(segments, cell_size_for(segments, kSegmentsPerCell), 2) {
  cells_.resize(grid_.columns() * grid_.rows());
  size_ = grid_.cell() * std::sqrt(static_cast<double>(grid_.columns() * grid_.columns() +
                                                       grid_.rows() * grid_.rows()));
  margin_ = static_cast<float>(kFloatMargin * size_ + kRayTolerance);
  RayBlock unused;
  for (std::size_t i = 0; i < RayBlock::kLanes; ++i) {
    unused.ax[i] = unused.ay[i] = unused.ux[i] = unused.uy[i] = unused.length[i] =
        std::numeric_limits<float>::quiet_NaN();
    unused.segment[i] = 0;
  }
  blocks_.push_back(unused);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    if (grid_.begin_of(c) == grid_.end_of(c)) continue;  // shares block 0
    cells_[c] = {static_cast<std::uint32_t>(blocks_.size()), 0};
    std::size_t lane = RayBlock::kLanes;
    for (const std::uint32_t* i = grid_.begin_of(c); i != grid_.end_of(c); ++i) {
      if (lane == RayBlock::kLanes) {
        blocks_.push_back(unused);
        ++cells_[c].count;
        lane = 0;
      }
      const Segment& s = segments[*i];
      RayBlock& block = blocks_.back();
      block.ax[lane] = static_cast<float>(s.a.x - grid_.origin().x);
      block.ay[lane] = static_cast<float>(s.a.y - grid_.origin().y);
      block.ux[lane] = static_cast<float>(s.u.x);
      block.uy[lane] = static_cast<float>(s.u.y);
      block.length[lane] = static_cast<float>(s.length);
      block.segment[lane] = *i;
      ++lane;
    }
  }
}

#define EYEBRIDGE_RAY_TARGET
#define EYEBRIDGE_RAY_CAST cast_scalar
#include "ray_walk.ipp"

}  // namespace eyebridge::world
