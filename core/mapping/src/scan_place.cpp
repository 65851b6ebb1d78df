// What is done with many beams of a scan at once. The loops that count most have no branches and
// call nothing, so that the compiler takes several beams at once, in each instruction set; it is
// told that their arrays are different ones.

#include <algorithm>

#include "eyebridge/base/instruction_sets.hpp"
#include "scan_rays.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scan_place.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace eyebridge::mapping::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Sets the extent of the beams by their tips.
inline void place_extent(ScanRays& rays) {
  // Of several beams at once, by hand: the compiler does not exchange what is smaller or larger.
  constexpr hn::ScalableTag<float> kFloat;
  constexpr std::size_t kLanes = hn::MaxLanes(kFloat);
  auto left = hn::Zero(kFloat);
  auto right = left;
  auto low = left;
  auto high = left;
  const float* const x = rays.tip_x.data();
  const float* const y = rays.tip_y.data();
  std::size_t i = 0;
  for (; i + kLanes <= rays.count; i += kLanes) {
    const auto tip_x = hn::LoadU(kFloat, x + i);
    const auto tip_y = hn::LoadU(kFloat, y + i);
    left = hn::Min(tip_x, left);
    right = hn::Max(tip_x, right);
    low = hn::Min(tip_y, low);
    high = hn::Max(tip_y, high);
  }
  float least_x = hn::GetLane(hn::MinOfLanes(kFloat, left));
  float most_x = hn::GetLane(hn::MaxOfLanes(kFloat, right));
  float least_y = hn::GetLane(hn::MinOfLanes(kFloat, low));
  float most_y = hn::GetLane(hn::MaxOfLanes(kFloat, high));
  for (; i < rays.count; ++i) {
    least_x = std::min(least_x, x[i]);
    most_x = std::max(most_x, x[i]);
    least_y = std::min(least_y, y[i]);
    most_y = std::max(most_y, y[i]);
  }
  std::int32_t any = 0;
  for (const std::int32_t kind : rays.kind) any |= kind;
  rays.extent = {any == ScanRays::kSilent, {least_x, least_y}, {most_x, most_y}};
}

/// Sorts directions by axis; false where one is no unit vector.
inline bool take_directions(std::span<const Vec2> directions, ScanRays& rays) {
  // Squares of lengths: of unit vectors, rounded.
  constexpr float kLeast = 0.9F;
  constexpr float kMost = 1.1F;
  float* const x = rays.x.data();
  float* const y = rays.y.data();
  std::int32_t bad = 0;
  EYEBRIDGE_DIFFERENT_ARRAYS
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto dx = static_cast<float>(directions[i].x);
    const auto dy = static_cast<float>(directions[i].y);
    x[i] = dx;
    y[i] = dy;
    const float square = dx * dx + dy * dy;
    bad |= (square > kLeast ? 0 : 1) | (square < kMost ? 0 : 1);
  }
  return bad == 0;
}

/// What readings are good for, where they are and how exactly.
inline void take_ranges(const BeamTable& table, const RayModel& model,
                        std::span<const double> ranges, ScanRays& rays) {
  constexpr double kFarthest = 1 << 21;  // cells; what met something is nearer
  const std::size_t count = ranges.size();
  const double* const range = ranges.data();
  float* const sigma = rays.sigma.data();
  float* const place = rays.place.data();
  std::int32_t* const kind = rays.kind.data();
  const double max_range = model.max_range;
  const double out_of_range = model.out_of_range;
  const double bias = model.bias;
  const double per_metre = model.per_metre;
  const double base = table.sigma(0.0);
  const double relative = table.sigma_relative();
  EYEBRIDGE_DIFFERENT_ARRAYS
  for (std::size_t i = 0; i < count; ++i) {
    const double r = range[i];
    const double ahead = (r - bias) * per_metre;
    const double not_behind = ahead > 0.0 ? ahead : 0.0;
    const double near_enough = not_behind < kFarthest ? not_behind : kFarthest;
    const double at_most = r < max_range ? r : max_range;  // NaN, too
    const double at_least = at_most > 0.0 ? at_most : 0.0;
    place[i] = static_cast<float>(near_enough);
    sigma[i] = static_cast<float>(base + relative * at_least);
  }
  if (!table.is_simple()) {
    for (std::size_t i = 0; i < count; ++i) {
      const double at_most = range[i] < max_range ? range[i] : max_range;
      sigma[i] = static_cast<float>(table.sigma(at_most > 0.0 ? at_most : 0.0));
    }
  }
  EYEBRIDGE_DIFFERENT_ARRAYS
  for (std::size_t i = 0; i < count; ++i) {
    const double r = range[i];
    const std::int32_t speaks = r >= 0.0 ? 1 : 0;
    const std::int32_t within = r < max_range ? 1 : 0;
    const std::int32_t is_range = r != out_of_range ? 1 : 0;
    kind[i] = speaks + (speaks & within & is_range);
  }
}

/// How far beams reach, and how far the cells along them are filled.
inline void place_beams(const BeamTable& table, const RayModel& model, ScanRays& rays) {
  // On a diagonal beam a column is sqrt(2) of a cell long.
  constexpr float kDiagonal = 1.5F;
  const std::size_t count = rays.count;
  const float* const sigma = rays.sigma.data();
  const float* const place = rays.place.data();
  const std::int32_t* const kind = rays.kind.data();
  const float* const x = rays.x.data();
  const float* const y = rays.y.data();
  std::int32_t* const level = rays.level.data();
  float* const reach = rays.reach.data();
  float* const clear = rays.clear.data();
  float* const corner_x = rays.corner_x.data();
  float* const corner_y = rays.corner_y.data();
  float* const tip_x = rays.tip_x.data();
  float* const tip_y = rays.tip_y.data();
  const auto close = static_cast<float>(model.close);
  const auto farthest = static_cast<float>(model.max_range * model.per_metre);
  const float unmet_clear = model.fills_unmet ? std::min(farthest, close) : 0.0F;
  const auto levels = static_cast<float>(table.levels());
  const auto highest = static_cast<float>(table.highest_level());
  EYEBRIDGE_DIFFERENT_ARRAYS
  for (std::size_t i = 0; i < count; ++i) {
    const float wanted = sigma[i] * levels + 0.5F;  // rounds: nothing here is negative
    const float nearest = wanted < highest ? wanted : highest;
    const auto of_blur = static_cast<std::int32_t>(nearest);
    const float around = table.reach_of(static_cast<float>(of_blur));
    const float sure = place[i] - kDiagonal * around;
    const float near_enough = sure < close ? sure : close;
    const float not_back = near_enough > 0.0F ? near_enough : 0.0F;
    const float last = place[i] + kDiagonal * around + kDiagonal;
    const float unmet = kind[i] == ScanRays::kUnmet ? unmet_clear : 0.0F;
    const float empty = kind[i] == ScanRays::kUnmet ? farthest : 0.0F;
    const float filled = kind[i] == ScanRays::kMet ? not_back : unmet;
    const float tip = kind[i] == ScanRays::kMet ? last : empty;
    level[i] = of_blur;
    reach[i] = around;
    clear[i] = filled;
    corner_x[i] = filled * x[i];
    corner_y[i] = filled * y[i];
    tip_x[i] = tip * x[i];
    tip_y[i] = tip * y[i];
  }
}

/// From where on beams say themselves what they cross: where those beside them are filled less far.
inline void place_own(ScanRays& rays) {
  // Half a cell less: one to the side of the beam may be filled less far.
  constexpr float kSlack = 0.5F;
  const std::size_t count = rays.count;
  const float* const clear = rays.clear.data();
  float* const own_from = rays.own_from.data();
  // Those at the ends have one to one side only.
  own_from[0] = own_from[count - 1] = 0.0F;
  EYEBRIDGE_DIFFERENT_ARRAYS
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const float beside = clear[i - 1] < clear[i + 1] ? clear[i - 1] : clear[i + 1];
    own_from[i] = (beside < clear[i] ? beside : clear[i]) - kSlack;
  }
}

bool place_rays(const BeamTable& table, const RayModel& model, std::span<const Vec2> directions,
                std::span<const double> ranges, ScanRays& rays) {
  rays.resize(ranges.size());
  if (!take_directions(directions, rays)) return false;
  take_ranges(table, model, ranges, rays);
  place_beams(table, model, rays);
  place_extent(rays);
  place_own(rays);
  return true;
}

}  // namespace
}  // namespace eyebridge::mapping::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyebridge::mapping {

void ScanRays::resize(std::size_t rays) {
  count = rays;
  for (std::vector<float>* each :
       {&x, &y, &sigma, &place, &reach, &clear, &own_from, &corner_x, &corner_y, &tip_x, &tip_y}) {
    each->resize(rays);
  }
  kind.resize(rays);
  level.resize(rays);
}

bool ScanRays::set(const BeamTable& table, const RayModel& model, std::span<const Vec2> directions,
                   std::span<const double> ranges) {
  return EYEBRIDGE_BEST(place_rays)(table, model, directions, ranges, *this);
}

}  // namespace eyebridge::mapping
#endif
