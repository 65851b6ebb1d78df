// The walk of a fan of rays through a RayGrid. Included by one source per instruction set, which
// has defined before:
//   EYEBRIDGE_RAY_TARGET   the attribute of functions of that instruction set, or nothing
//   EYEBRIDGE_RAY_CAST     the name of the member function
//   candidates_in()        which lanes of a block a ray may hit before query.reach, as bits
// Text is shared, not a template, because g++ inlines no function of a richer instruction set into
// one of a poorer, and the linker must not take one for the other.

EYEBRIDGE_RAY_TARGET
void RayGrid::EYEBRIDGE_RAY_CAST(Vec2 origin, std::span<const Vec2> directions, double max_range,
                                 std::span<double> ranges) const {
  const double cell = grid_.cell();
  const double per_cell = 1.0 / cell;
  const double columns = static_cast<double>(grid_.columns());
  const double rows = static_cast<double>(grid_.rows());
  const std::ptrdiff_t row_step = static_cast<std::ptrdiff_t>(grid_.columns());
  // The box that rays are clipped to: the outermost ring of cells is empty and takes up what
  // rounding lets a ray go too far. Coordinates are in cells from here on.
  constexpr double kRing = 0.5;
  const Vec2 start = per_cell * (origin - grid_.origin());
  const bool inside =
      start.x > kRing && start.x < columns - kRing && start.y > kRing && start.y < rows - kRing;

  // Where the rays enter the grid: the same place for all that start inside.
  double entry = 0.0;  // range
  std::ptrdiff_t entry_cell = 0;
  Vec2 in_cell;  // 0 … 1 each, but for rounding
  RayQuery query{};
  query.margin = margin_;
  const auto enter = [&](Vec2 p) EYEBRIDGE_RAY_TARGET {
    const Vec2 place = grid_.origin() + cell * p;
    const std::size_t column = grid_.column_of(place.x);
    const std::size_t row = grid_.row_of(place.y);
    entry_cell = static_cast<std::ptrdiff_t>(row * grid_.columns() + column);
    in_cell = p - Vec2{static_cast<double>(column), static_cast<double>(row)};
    query.x = static_cast<float>(p.x * cell);
    query.y = static_cast<float>(p.y * cell);
  };
  if (inside) enter(start);

  for (std::size_t ray = 0; ray < directions.size(); ++ray) {
    const Vec2 d = directions[ray];
    const bool right = d.x >= 0.0;
    const bool up = d.y >= 0.0;
    // Infinite where the ray is parallel to an axis; no crossing is ever nearer then.
    const double cells_x = cell / std::fabs(d.x);
    const double cells_y = cell / std::fabs(d.y);
    const double out_x = (right ? columns - kRing - start.x : start.x - kRing) * cells_x;
    const double out_y = (up ? rows - kRing - start.y : start.y - kRing) * cells_y;
    const double out = out_x < out_y ? out_x : out_y;
    const double limit = out < max_range ? out : max_range;
    ranges[ray] = max_range;
    if (!inside) {
      const double gap_x = right ? kRing - start.x : start.x - (columns - kRing);
      const double gap_y = up ? kRing - start.y : start.y - (rows - kRing);
      const double in_x = gap_x > 0.0 ? gap_x * cells_x : 0.0;
      const double in_y = gap_y > 0.0 ? gap_y * cells_y : 0.0;
      entry = in_x > in_y ? in_x : in_y;
      if (!(entry < limit)) continue;
      enter(start + (entry * per_cell) * d);
    }
    double next_x = d.x == 0.0 ? kNever : entry + (right ? 1.0 - in_cell.x : in_cell.x) * cells_x;
    double next_y = d.y == 0.0 ? kNever : entry + (up ? 1.0 - in_cell.y : in_cell.y) * cells_y;
    const std::ptrdiff_t step_x = right ? 1 : -1;
    const std::ptrdiff_t step_y = up ? row_step : -row_step;
    const Cell* at = cells_.data() + entry_cell;
    query.dx = static_cast<float>(d.x);
    query.dy = static_cast<float>(d.y);

    double best = limit;
    for (;;) {
      const bool by_x = next_x < next_y;
      const double border = by_x ? next_x : next_y;
      // Hits behind the border are found from their own cells.
      const double reach = border < best ? border : best;
      query.reach = static_cast<float>(reach - entry);
      const RayBlock* block = blocks_.data() + at->first;
      const RayBlock* const end = block + at->count;
      do {  // every cell has a block: one branch less to guess
        for (unsigned lanes = candidates_in(*block, query); lanes != 0; lanes &= lanes - 1) {
          const std::uint32_t hit = block->segment[__builtin_ctz(lanes)];
          best = nearer_hit(segments_[hit], origin, d, best);
        }
      } while (++block != end);
      // A hit in a later cell cannot be nearer than the border to it. Also ends on NaN.
      if (!(border < best)) break;
      if (by_x) {
        at += step_x;
        next_x += cells_x;
      } else {
        at += step_y;
        next_y += cells_y;
      }
    }
    if (best < limit) ranges[ray] = best;
  }
}
