// Discs of a BodyMap, a register of them at a time. Included by one source per instruction set, as
// ray_lanes.ipp is.

#ifndef EYEBRIDGE_DISC_LANES_IPP
#define EYEBRIDGE_DISC_LANES_IPP

#include "ray_extent.ipp"
#include "run_list.ipp"

namespace {

/// So few are all looked at, wherever they are.
constexpr std::size_t kFewDiscs = 24;

/// So many registers of a row of cells are listed at once.
constexpr std::size_t kUsualStarts = 4;

/// Where registers of BodyMap::Rows begin, over many rows of cells.
template <std::size_t kMost>
struct Registers : RunList<kMost, kUsualStarts, kFloats> {
  /// Adds those with the discs from `begin` to `end`, as RunList does.
  template <class Full>
  EYEBRIDGE_RAY_TARGET void add(std::size_t begin, std::size_t end, Full full) {
    RunList<kMost, kUsualStarts, kFloats>::add(static_cast<std::uint32_t>(begin),
                                               (end - begin + kFloats - 1) / kFloats, full);
  }

  /// Adds those with all discs of `map`, of which there are `discs`, that lie so far from `origin`
  /// as get_reaches() says; and others.
  template <class GetReaches, class Full>
  EYEBRIDGE_RAY_TARGET void add(const BodyMap& map, std::size_t discs, Vec2 origin,
                                GetReaches get_reaches, Full full) {
    if (discs <= kFewDiscs) {
      add(0, discs, full);
      return;
    }
    const BodyMap::Box box = box_around(map, origin, get_reaches());
    for (std::size_t row = box.first_row; row <= box.last_row; ++row) {
      add(map.begin_of(box, row), map.end_of(box, row), full);
    }
  }
};

/// A disc, seen from where rays begin.
struct SeenDisc {
  double wx, wy;
  double radius_squared;
};

/// nearer_disc_hit() of rays that do not begin in the disc; `wx`, `wy`: its centre, seen from where
/// they do, one for all or one each. Where they pass by, infinity or no number.
template <class Values>
EYEBRIDGE_RAY_TARGET inline Lanes range_to_disc(Values wx, Values wy, double radius_squared,
                                                Lanes dx, Lanes dy) {
  const Lanes never = Lanes{} + std::numeric_limits<double>::infinity();
  const Lanes along = wx * dx + wy * dy;
  const Lanes across = dx * wy - dy * wx;
  const Lanes range = along - root_of(radius_squared - across * across);
  return along > 0.0 ? range : never;
}

/// The same for a register of rays from one place.
EYEBRIDGE_RAY_TARGET inline void meet_register(const SeenDisc& disc, const double* dxs,
                                               const double* dys, double* ranges) {
  Lanes dx;
  Lanes dy;
  Lanes nearest;
  load(dx, dxs);
  load(dy, dys);
  load(nearest, ranges);
  // Than what is no number, `nearest` is smaller.
  nearest = smaller(range_to_disc(disc.wx, disc.wy, disc.radius_squared, dx, dy), nearest);
  std::memcpy(ranges, &nearest, sizeof nearest);
}

}  // namespace

#endif
