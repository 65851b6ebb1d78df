// The walk of a fan of rays through a RayGrid. Included by one source per instruction set, which
// has defined before:
//   EYEBRIDGE_RAY_TARGET   the attribute of functions of that instruction set, or nothing
//   EYEBRIDGE_RAY_CAST     the name of the member function
//   candidates_in()        which lanes of a block a ray may hit before `best`, as bits
// Text is shared, not a template, because g++ inlines no function of a richer instruction set into
// one of a poorer, and both must not be merged by the linker.

EYEBRIDGE_RAY_TARGET
void RayGrid::EYEBRIDGE_RAY_CAST(Vec2 origin, std::span<const Vec2> directions, double max_range,
                                 std::span<double> ranges) const {
  const double cell = grid_.cell();
  const double per_cell = 1.0 / cell;
  const Vec2 corner = grid_.origin();
  const double columns = static_cast<double>(grid_.columns());
  const double rows = static_cast<double>(grid_.rows());
  // The box that rays are clipped to: the outermost ring of cells is empty and takes up what
  // rounding lets a ray go too far. Coordinates are in cells from here on.
  constexpr double kRing = 0.5;
  const Vec2 start{(origin.x - corner.x) * per_cell, (origin.y - corner.y) * per_cell};
  const bool inside =
      start.x > kRing && start.x < columns - kRing && start.y > kRing && start.y < rows - kRing;

  for (std::size_t ray = 0; ray < directions.size(); ++ray) {
    const Vec2 d = directions[ray];
    const bool right = d.x >= 0.0;
    const bool up = d.y >= 0.0;
    // Infinite where the ray is parallel to an axis; no crossing is ever nearer then.
    const double cells_x = cell / std::fabs(d.x);
    const double cells_y = cell / std::fabs(d.y);
    double best = max_range;
    double entry = 0.0;
    Vec2 p = start;
    {
      // Ranges at which the ray leaves the box, and where it enters it from outside.
      const double out_x = (right ? columns - kRing - start.x : start.x - kRing) * cells_x;
      const double out_y = (up ? rows - kRing - start.y : start.y - kRing) * cells_y;
      const double out = out_x < out_y ? out_x : out_y;
      if (!inside) {
        const double gap_x = right ? kRing - start.x : start.x - (columns - kRing);
        const double gap_y = up ? kRing - start.y : start.y - (rows - kRing);
        const double in_x = gap_x > 0.0 ? gap_x * cells_x : 0.0;
        const double in_y = gap_y > 0.0 ? gap_y * cells_y : 0.0;
        entry = in_x > in_y ? in_x : in_y;
        if (!(entry < out && entry < max_range)) {
          ranges[ray] = max_range;
          continue;
        }
        p = {start.x + entry * per_cell * d.x, start.y + entry * per_cell * d.y};
      }
      if (out < best) best = out;
    }
    const double limit = best;

    std::size_t column = grid_.column_of(corner.x + p.x * cell);
    std::size_t row = grid_.row_of(corner.y + p.y * cell);
    const double fraction_x = p.x - static_cast<double>(column);
    const double fraction_y = p.y - static_cast<double>(row);
    double next_x = d.x == 0.0 ? kNever : entry + (right ? 1.0 - fraction_x : fraction_x) * cells_x;
    double next_y = d.y == 0.0 ? kNever : entry + (up ? 1.0 - fraction_y : fraction_y) * cells_y;
    const std::ptrdiff_t step_x = right ? 1 : -1;
    const std::ptrdiff_t step_y = up ? static_cast<std::ptrdiff_t>(grid_.columns())
                                     : -static_cast<std::ptrdiff_t>(grid_.columns());
    std::ptrdiff_t at = static_cast<std::ptrdiff_t>(row * grid_.columns() + column);

    RayQuery query;
    query.x = static_cast<float>(p.x * cell);
    query.y = static_cast<float>(p.y * cell);
    query.dx = static_cast<float>(d.x);
    query.dy = static_cast<float>(d.y);
    query.margin = margin_;
    query.best = static_cast<float>(best - entry < 2 * size_ ? best - entry : 2 * size_);

    for (;;) {
      const Cell cell_blocks = cells_[static_cast<std::size_t>(at)];
      for (std::uint32_t b = cell_blocks.first; b < cell_blocks.first + cell_blocks.count; ++b) {
        const RayBlock& block = blocks_[b];
        unsigned lanes = candidates_in(block, query);
        while (lanes != 0) {
          const unsigned lane = static_cast<unsigned>(__builtin_ctz(lanes));
          lanes &= lanes - 1;
          best = nearer_hit(segments_[block.segment[lane]], origin, d, best);
        }
      }
      // A hit in a later cell cannot be nearer than the border to it. Also ends on NaN.
      const bool by_x = next_x < next_y;
      if (!((by_x ? next_x : next_y) < best)) break;
      query.best = static_cast<float>(best - entry < 2 * size_ ? best - entry : 2 * size_);
      if (by_x) {
        at += step_x;
        next_x += cells_x;
      } else {
        at += step_y;
        next_y += cells_y;
      }
    }
    ranges[ray] = best < limit ? best : max_range;
  }
}
