#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "maze_formats.hpp"
#include "maze_layout.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

using world::MazeCell;

// A byte a cell, a bit a wall. Who wrote it decided which bit is which side, and in which order the
// cells follow one another; the file does not say. But each wall between two cells is in the bytes
// of both, and the outer boundary is closed: only the right reading fits. It leaves the eight ways
// to look at a maze (turned, mirrored): the robot of a contest starts in the lower left cell, with
// walls on three sides, facing up.

/// Bits of the four sides of a cell; the order of kSides.
using Bits = std::array<unsigned, 4>;

/// North, east, south, west: what most files have.
constexpr Bits kUsualBits = {1, 2, 4, 8};

/// How the bytes become cells.
struct Order {
  bool by_columns = true;  ///< Column by column, else row by row.
  bool from_right = false;
  bool from_top = false;
};

struct Way {
  Bits bits = kUsualBits;
  Order order;
  bool ones_are_open = false;
};

/// A share of the shared walls: with more that do not fit, the file is something else.
constexpr double kMostMisfits = 0.05;

class BinaryReader {
 public:
  explicit BinaryReader(const MazeSource& source)
      : source_(source),
        side_(source.bytes.size() == 256 ? 16 : 32),
        warnings_(source.file, source.warnings) {}

  world::WorldModel read() {
    const Way way = best_way();
    const int misfits = misfits_of(way, nullptr);
    const int shared = 2 * side_ * (side_ + 1);
    if (misfits > kMostMisfits * shared) {
      throw ConfigError({source_.file, 0, 0},
                        std::to_string(source_.bytes.size()) +
                            " bytes that are no maze: for no order of bits do more than " +
                            std::to_string(shared - misfits) + " of " + std::to_string(shared) +
                            " walls fit those of the neighbours and the boundary");
    }
    world::MazeGrid grid = grid_of(way);
    if (misfits > 0) {
      std::optional<MazeCell> first;
      misfits_of(way, &first);
      warnings_.add(0, 0,
                    std::to_string(misfits) +
                        " walls that only one of their two cells has, or that "
                        "the boundary lacks, the first at cell " +
                        in_words(*first) + ": where one cell has a wall, there is one");
    }
    if (!is_contest_start([&](Side side) { return has_wall(grid, {}, side); })) {
      warnings_.add(0, 0,
                    "expected the cell at the lower left, a contest's start, with walls on three "
                    "sides and open at the top: the maze may be turned or mirrored");
    }
    if (source_.start_places != nullptr) source_.start_places->push_back({source_.file, 0, 0});
    return contest_maze(std::move(grid), {});
  }

 private:
  /// Whether a cell has a wall at a side, as its byte says.
  [[nodiscard]] bool says(const Way& way, MazeCell cell, Side side) const {
    const int column = way.order.from_right ? side_ - 1 - cell.column : cell.column;
    const int row = way.order.from_top ? side_ - 1 - cell.row : cell.row;
    const int at = way.order.by_columns ? column * side_ + row : row * side_ + column;
    const auto byte = static_cast<unsigned char>(source_.bytes[static_cast<std::size_t>(at)]);
    return ((byte & way.bits[static_cast<std::size_t>(side)]) != 0) != way.ones_are_open;
  }

  /// Walls that only one of their cells has, and open places of the boundary. `first`, unless null,
  /// gets the first cell of one.
  int misfits_of(const Way& way, std::optional<MazeCell>* first) const {
    int count = 0;
    const auto add = [&](MazeCell cell) {
      if (count++ == 0 && first != nullptr) *first = cell;
    };
    for (int column = 0; column < side_; ++column) {
      for (int row = 0; row < side_; ++row) {
        const MazeCell cell{column, row};
        const bool north = says(way, cell, Side::North);
        const bool east = says(way, cell, Side::East);
        if (row + 1 == side_ ? !north : north != says(way, {column, row + 1}, Side::South)) {
          add(cell);
        }
        if (column + 1 == side_ ? !east : east != says(way, {column + 1, row}, Side::West)) {
          add(cell);
        }
        if (row == 0 && !says(way, cell, Side::South)) add(cell);
        if (column == 0 && !says(way, cell, Side::West)) add(cell);
      }
    }
    return count;
  }

  /// Whether the start is as a contest has it, by what `has` says of its sides.
  template <class Has>
  static bool is_contest_start(Has has) {
    return !has(Side::North) && has(Side::East) && has(Side::South) && has(Side::West);
  }

  /// Fewest misfits, then a contest's start, then the usual bits, then the usual order.
  [[nodiscard]] Way best_way() const {
    std::optional<Way> best;
    std::tuple<int, bool, bool, int> least{};
    Bits bits = kUsualBits;
    do {
      for (int order = 0; order < 8; ++order) {
        for (const bool ones_are_open : {false, true}) {
          const Way way{
              bits, {(order & 1) == 0, (order & 2) != 0, (order & 4) != 0}, ones_are_open};
          const bool starts = is_contest_start([&](Side side) { return says(way, {}, side); });
          const std::tuple rank{misfits_of(way, nullptr), !starts,
                                ones_are_open || bits != kUsualBits, order};
          if (best && rank >= least) continue;
          best = way;
          least = rank;
        }
      }
    } while (std::next_permutation(bits.begin(), bits.end()));
    return *best;
  }

  [[nodiscard]] world::MazeGrid grid_of(const Way& way) const {
    const auto side = static_cast<std::size_t>(side_);
    world::MazeGrid grid = empty_maze(side, side, {source_.file, 0, 0});
    grid.cell = source_.cell.value_or(kContestCell);
    for (int column = 0; column < side_; ++column) {
      for (int row = 0; row < side_; ++row) {
        for (const Side at : kSides) {
          if (says(way, {column, row}, at)) edge(grid, {column, row}, at) = 1;
        }
      }
    }
    return grid;
  }

  const MazeSource& source_;
  int side_;
  Warnings warnings_;
};

}  // namespace

world::WorldModel read_binary_maze(const MazeSource& source) { return BinaryReader(source).read(); }

}  // namespace eyebridge::files
