// Discs of a BodyMap, a register of them at a time. Included by one source per instruction set, as
// ray_lanes.ipp is.

#ifndef EYEBRIDGE_DISC_LANES_IPP
#define EYEBRIDGE_DISC_LANES_IPP

#include "ray_extent.ipp"

namespace {

/// So few are all looked at, wherever they are.
constexpr std::size_t kFewDiscs = 24;

/// Registers that are looked at together; so many of a row of cells are listed at once.
constexpr std::size_t kMostStarts = 64;
constexpr std::size_t kUsualStarts = 4;

/// Calls look_at(starts, size) with where registers of `rows` begin, one or more times, so that all
/// discs that touch get_extent() are in one of them.
///
/// They are listed over many rows of cells: one loop through them instead of short ones, of which
/// nobody can foresee the ends.
template <class GetExtent, class LookAt>
EYEBRIDGE_RAY_TARGET inline void each_register(const BodyMap& map, const BodyMap::Rows& rows,
                                               GetExtent get_extent, LookAt look_at) {
  std::uint32_t starts[kMostStarts + kUsualStarts];
  std::size_t size = 0;
  const auto take = [&](std::size_t begin, std::size_t end) EYEBRIDGE_RAY_TARGET {
    for (;;) {
      // So many, whether there are or not.
      for (std::size_t i = 0; i < kUsualStarts; ++i) {
        starts[size + i] = static_cast<std::uint32_t>(begin + i * kFloats);
      }
      const std::size_t registers = (end - begin + kFloats - 1) / kFloats;
      size += registers < kUsualStarts ? registers : kUsualStarts;
      if (size >= kMostStarts) [[unlikely]] {
        look_at(starts, size);
        size = 0;
      }
      if (registers <= kUsualStarts) return;
      begin += kUsualStarts * kFloats;
    }
  };
  if (rows.nobody <= kFewDiscs) {
    take(0, rows.nobody);
  } else {
    const Extent extent = get_extent();
    const BodyMap::Box box = map.box(extent.low, extent.high);
    for (std::size_t row = box.first_row; row <= box.last_row; ++row) {
      take(map.begin_of(box, row), map.end_of(box, row));
    }
  }
  look_at(starts, size);
}

/// A byte for each register that each_register() lists: bits of lanes.
struct LaneMarks {
  static constexpr std::size_t kWord = sizeof(std::uint64_t);

  explicit LaneMarks(std::size_t size) { std::memset(bytes + size / kWord * kWord, 0, kWord); }

  /// Calls visit(n, lane) for each lane that is set in the first `size` registers.
  template <class Visit>
  EYEBRIDGE_RAY_TARGET void each(std::size_t size, Visit visit) const {
    for (std::size_t n = 0; n < size; n += kWord) {
      std::uint64_t word;
      std::memcpy(&word, bytes + n, kWord);
      for (; word != 0; word &= word - 1) {
        const auto bit = static_cast<std::size_t>(__builtin_ctzll(word));
        visit(n + bit / 8, bit % 8);
      }
    }
  }

  std::uint8_t bytes[kMostStarts + kUsualStarts + kWord];
};

}  // namespace

#endif
