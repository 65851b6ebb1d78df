// Discs of a BodyMap in registers.

/// No body is farther away than this, metres: infinite ranges need an end.
constexpr double kLongestRay = 1e9;

/// For the rounding of ends of rays, metres.
constexpr double kExtentMargin = 1e-6;

/// Up to this many discs are all looked at, wherever they are.
constexpr std::size_t kFewDiscs = 24;

/// Registers of a row of cells that are listed at once.
constexpr std::size_t kUsualStarts = 4;

/// The cells of `map` that hold all discs less than `margin` metres from one of `count` rays, which
/// begin at `origin` and end at `best`. The arrays are filled up to a whole register.
HWY_INLINE BodyMap::Box box_around(const BodyMap& map, Vec2 origin, const double* dx,
                                   const double* dy, const double* best, std::size_t count,
                                   double margin) {
  Doubles left = hn::Zero(kDouble);
  Doubles down = left;
  Doubles right = left;
  Doubles up = left;
  const Doubles longest = filled(kLongestRay);
  for (std::size_t i = 0; i < count; i += kLanes) {
    const Doubles range = hn::Min(load(best + i), longest);
    const Doubles x = load(dx + i) * range;
    const Doubles y = load(dy + i) * range;
    left = hn::Min(x, left);
    down = hn::Min(y, down);
    right = hn::Max(x, right);
    up = hn::Max(y, up);
  }
  const auto least = [](Doubles v) HWY_ATTR { return hn::GetLane(hn::MinOfLanes(kDouble, v)); };
  const auto most = [](Doubles v) HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(kDouble, v)); };
  return map.box({origin.x + least(left) - margin, origin.y + least(down) - margin},
                 {origin.x + most(right) + margin, origin.y + most(up) + margin});
}

/// Where registers of BodyMap::Rows begin, over many rows of cells.
template <std::size_t kMost>
struct Registers : RunList<kMost, kUsualStarts, kFloats> {
  /// Adds those with the discs from `begin` to `end`, as RunList does.
  template <class Full>
  HWY_INLINE void add_discs(std::size_t begin, std::size_t end, Full full) {
    this->add(static_cast<std::uint32_t>(begin), (end - begin + kFloats - 1) / kFloats, full);
  }

  /// Adds those with all discs of `map`, of which there are `discs`, in the box that get_box()
  /// gives; and others.
  template <class GetBox, class Full>
  HWY_INLINE void add_box(const BodyMap& map, std::size_t discs, GetBox get_box, Full full) {
    if (discs <= kFewDiscs) {
      add_discs(0, discs, full);
      return;
    }
    const BodyMap::Box box = get_box();
    for (std::size_t row = box.first_row; row <= box.last_row; ++row) {
      add_discs(map.begin_of(box, row), map.end_of(box, row), full);
    }
  }
};

/// nearer_disc_hit() of rays that do not begin in the disc; `wx`, `wy`: its centre, seen from where
/// they do. Where they pass by, infinity or NaN.
HWY_INLINE Doubles range_to_disc(Doubles wx, Doubles wy, Doubles radius_squared, Doubles dx,
                                 Doubles dy) {
  const Doubles never = filled(std::numeric_limits<double>::infinity());
  const Doubles along = wx * dx + wy * dy;
  const Doubles across = dx * wy - dy * wx;
  const Doubles range = along - hn::Sqrt(radius_squared - across * across);
  return hn::IfThenElse(along > hn::Zero(kDouble), range, never);
}

/// The same for a register of rays from one place, `w` from the disc, as nearer_disc_hit().
HWY_INLINE void meet_register(Vec2 w, double radius_squared, const double* dx, const double* dy,
                              double* best) {
  const Doubles range =
      range_to_disc(filled(w.x), filled(w.y), filled(radius_squared), load(dx), load(dy));
  // Where `range` is NaN, Min() gives the second.
  hn::StoreU(hn::Min(range, load(best)), kDouble, best);
}
