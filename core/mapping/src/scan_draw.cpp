// Draws many beams of a scan.

#include <algorithm>
#include <array>

#include "eyebridge/base/instruction_sets.hpp"
#include "scan_rays.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scan_draw.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace eyebridge::mapping::HWY_NAMESPACE {
namespace {

/// The whole number below or at `x`, |x| < 2^31.
inline std::int32_t floor_of(float x) {
#if HWY_TARGET != HWY_EMU128
  return static_cast<std::int32_t>(__builtin_floorf(x));  // an instruction
#else
  const auto cut = static_cast<std::int32_t>(x);
  return cut - (static_cast<float>(cut) > x ? 1 : 0);
#endif
}

/// In which way the columns of a beam go: differences of indices.
struct RayWay {
  std::int64_t step;    ///< From column to column.
  std::int64_t across;  ///< From cell to cell of a column.
};

/// Where some beams go, in the terms of BeamWalk, from the lower left corner of the sensor's cell.
struct Walks {
  static constexpr std::size_t kMost = 64;
  float slope[kMost];
  float across[kMost];          ///< In the column of cell `lead`.
  float entry[kMost];           ///< How far cell `lead` is within the blur's reach.
  float first[kMost];           ///< From where something was met to cell 0, along the columns.
  std::int32_t exact[kMost];    ///< The cell where, of the column of `middle`.
  std::int32_t begin[kMost];    ///< The first cell that the beam says itself that it crosses.
  std::int32_t lead[kMost];     ///< From here on the blur says it.
  std::int32_t crossed[kMost];  ///< The first cell that may not be crossed.
  std::int32_t middle[kMost];   ///< The cell in whose column something was met.
  std::int32_t way[kMost];      ///< Index of RayWays.
};

inline void walk_rays(const RayFrame& frame, const ScanRays& rays, std::size_t start,
                      std::size_t count, Walks& w) {
  const float* const x = rays.x.data() + start;
  const float* const y = rays.y.data() + start;
  const float* const place = rays.place.data() + start;
  const float* const reach = rays.reach.data() + start;
  const float* const own_from = rays.own_from.data() + start;
  const auto ox = static_cast<float>(frame.origin.x - static_cast<double>(frame.column));
  const auto oy = static_cast<float>(frame.origin.y - static_cast<double>(frame.row));
  EYEBRIDGE_DIFFERENT_ARRAYS
  for (std::size_t i = 0; i < count; ++i) {
    const float ax = x[i] < 0.0F ? -x[i] : x[i];
    const float ay = y[i] < 0.0F ? -y[i] : y[i];
    const bool steep = ay > ax;
    const float major = steep ? y[i] : x[i];
    const float minor = steep ? x[i] : y[i];
    const float share = steep ? ay : ax;
    const bool back = major < 0.0F;
    const float ahead = 0.5F - (steep ? oy : ox);
    const float offset = back ? -ahead : ahead;
    const float slope = minor / share;
    const float across = (steep ? ox : oy) + offset * slope;
    const float first = offset - place[i] * share;
    const std::int32_t crossed = -floor_of(first + reach[i]);
    const std::int32_t lead = crossed > 1 ? crossed : 1;
    const std::int32_t begin = -floor_of(offset - own_from[i] * share);
    const auto steps = static_cast<float>(lead);
    w.slope[i] = slope;
    w.across[i] = across + slope * steps;
    w.entry[i] = first + reach[i] + steps;
    w.first[i] = first;
    w.exact[i] = floor_of(across - first * slope);
    w.begin[i] = begin > 1 ? begin : 1;  // the sensor's own cell, 0, may not be on the walk
    w.lead[i] = lead;
    w.crossed[i] = crossed;
    w.middle[i] = -floor_of(first + 0.5F);
    w.way[i] = (steep ? 2 : 0) + (back ? 1 : 0);
  }
}

/// What a beam that goes well within the box says of cells. Gives what it says of the sensor's own.
inline float draw_ray(const BeamTable::Blur& blur, float far, const Walks& w, std::size_t i,
                      const RayWay& way, std::int64_t own, ScanNotes::Writer out) {
  constexpr int kBits = 32;
  constexpr float kOne = 4294967296.0F;
  const auto slope = static_cast<std::int64_t>(w.slope[i] * kOne);
  const std::int32_t lead = w.lead[i];
  std::int64_t along = own + w.begin[i] * way.step;
  std::int64_t across = static_cast<std::int64_t>(w.across[i] * kOne);
  if (w.begin[i] < lead) {
    across -= (lead - w.begin[i]) * slope;
    for (std::int32_t k = w.begin[i]; k < lead; ++k, along += way.step, across += slope) {
      out.say(static_cast<std::size_t>(along + (across >> kBits) * way.across), far);
    }
  } else {
    along = own + lead * way.step;
  }
  // In the column of the reading the cell that it lies in counts, which need not be the one that
  // the beam is in at the column's middle.
  const std::int32_t middle = w.middle[i];
  const std::int64_t exact = w.exact[i];
  auto entry = static_cast<std::int64_t>(w.entry[i] * static_cast<float>(blur.step));
  const std::int32_t end = w.crossed[i] + blur.cells;
  for (std::int32_t k = lead; k < end; ++k) {
    const std::int64_t cell = k == middle ? exact : across >> kBits;
    out.say(static_cast<std::size_t>(along + cell * way.across),
            blur.evidence[static_cast<std::size_t>(entry >> kBits)]);
    along += way.step;
    across += slope;
    entry += blur.step;
  }
  return w.crossed[i] > 0 ? far : blur.at(w.first[i]);
}

float draw_rays(const BeamTable& table, const RayFrame& frame, ScanRays& rays,
                ScanNotes::Writer out) {
  constexpr double kMargin = 1.0;  // cells: as far from its middle line may a cell of a beam be
  const std::int64_t stride = frame.box.stride;
  const std::int64_t own_cell = frame.row * stride + frame.column;
  const std::array<RayWay, 4> ways{{{1, stride}, {-1, stride}, {stride, 1}, {-stride, 1}}};
  const double columns = frame.box.columns - kMargin;
  const double rows = frame.box.rows - kMargin;
  const auto is_inside = [=](double x, double y) {
    return x >= kMargin && y >= kMargin && x <= columns && y <= rows;
  };
  const Vec2 origin = frame.origin;
  if (frame.clipped && !is_inside(origin.x, origin.y)) return kNoEvidence;
  float own = kNoEvidence;
  Walks w;
  for (std::size_t start = 0; start < rays.count; start += Walks::kMost) {
    const std::size_t count = std::min(rays.count - start, Walks::kMost);
    walk_rays(frame, rays, start, count, w);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t ray = start + i;
      if (rays.kind[ray] != ScanRays::kMet) continue;
      if (frame.clipped && !is_inside(origin.x + rays.tip_x[ray], origin.y + rays.tip_y[ray])) {
        continue;
      }
      rays.kind[ray] = ScanRays::kSilent;
      const BeamTable::Blur& blur = table.blur_of_level(rays.level[ray]);
      const RayWay& way = ways[static_cast<std::size_t>(w.way[i])];
      const float said = draw_ray(blur, table.crossed, w, i, way, own_cell, out);
      own = own > said ? own : said;
    }
  }
  return own;
}

}  // namespace
}  // namespace eyebridge::mapping::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyebridge::mapping {

float ScanRays::draw(const BeamTable& table, const RayFrame& frame, ScanNotes::Writer out) {
  return EYEBRIDGE_BEST(draw_rays)(table, frame, *this, out);
}

}  // namespace eyebridge::mapping
#endif
