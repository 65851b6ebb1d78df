// The walk of a fan of rays through a RayGrid. Included by one source per instruction set, which
// has defined before:
//   EYEBRIDGE_RAY_TARGET   the attribute of functions of that instruction set, or nothing
//   EYEBRIDGE_RAY_CAST     the name of the member function
//   candidates_in()        which lanes of a block a ray may hit before query.reach, as bits
// Text is shared, not a template, because g++ inlines no function of a richer instruction set into
// one of a poorer, and the linker must not take one for the other.

namespace {

/// Least of `best` and the ranges to the segments in `lanes`. Not inlined: what the walk needs
/// stays in registers, and most rays come here once, at their end.
EYEBRIDGE_RAY_TARGET inline double nearest_of(const RayBlock& block, unsigned lanes,
                                              const Segment* segments, Vec2 origin, Vec2 direction,
                                              double best) {
  for (; lanes != 0; lanes &= lanes - 1) {
    const std::uint32_t hit = block.segment[__builtin_ctz(lanes)];
    best = nearer_hit(segments[hit], origin, direction, best);
  }
  return best;
}

}  // namespace

EYEBRIDGE_RAY_TARGET
void RayGrid::EYEBRIDGE_RAY_CAST(Vec2 origin, std::span<const Vec2> directions, double max_range,
                                 std::span<double> ranges) const {
  const std::ptrdiff_t row_step = static_cast<std::ptrdiff_t>(grid_.columns());
  // In two passes: how a ray starts takes divisions, and those would wait at each wrongly guessed
  // branch of the walk before.
  constexpr std::size_t kChunk = 64;
  RayStart starts[kChunk];
  for (std::size_t first = 0; first < directions.size(); first += kChunk) {
    const std::size_t rest = directions.size() - first;
    const std::size_t count = rest < kChunk ? rest : kChunk;
    start_rays(origin, directions.subspan(first, count), max_range, starts);

    for (std::size_t i = 0; i < count; ++i) {
      const RayStart& start = starts[i];
      const Vec2 d = directions[first + i];
      const std::ptrdiff_t step_x = d.x >= 0.0 ? 1 : -1;
      const std::ptrdiff_t step_y = d.y >= 0.0 ? row_step : -row_step;
      const RayQuery query{start.x, start.y, static_cast<float>(d.x), static_cast<float>(d.y),
                           margin_};
      double next_x = start.next_x;
      double next_y = start.next_y;
      double best = start.limit;
      for (const Cell* at = cells_.data() + start.cell;;) {
        const bool by_x = next_x < next_y;
        const double border = by_x ? next_x : next_y;
        // Hits behind the border are found from their own cells.
        const double reach = (border < best ? border : best) - start.entry;
        const RayBlock* block = blocks_.data() + at->first;
        const RayBlock* const end = block + at->count;
        do {  // every cell has a block: one branch less to guess
          const unsigned lanes = candidates_in(*block, query, static_cast<float>(reach));
          if (lanes != 0) best = nearest_of(*block, lanes, segments_.data(), origin, d, best);
        } while (++block != end);
        // A hit in a later cell cannot be nearer than the border to it. Also ends on NaN.
        if (!(border < best)) break;
        at += by_x ? step_x : step_y;
        const double beyond_x = next_x + start.cells_x;
        const double beyond_y = next_y + start.cells_y;
        next_x = by_x ? beyond_x : next_x;
        next_y = by_x ? next_y : beyond_y;
      }
      ranges[first + i] = best < start.limit ? best : max_range;
    }
  }
}
