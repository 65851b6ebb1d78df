#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace eyebridge::mapping {

/// Lower envelope of parabolas (x - site)^2 + height over whole numbers, exact: the one step of the
/// distance transform of P. Felzenszwalb and D. Huttenlocher, "Distance Transforms of Sampled
/// Functions", Theory of Computing 8 (2012) 415. Not thread-safe.
class Envelope {
 public:
  using Number = std::int64_t;

  /// For at most `sites` parabolas.
  explicit Envelope(std::size_t sites) : parabolas_(sites) {}

  void clear() { count_ = 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Sites come from left to right, each once.
  void add(Number site, Number height) {
    Number first = std::numeric_limits<Number>::min();
    while (count_ > 0) {
      const Parabola& last = parabolas_[count_ - 1];
      // The last x at which the older parabola is not above the new one.
      const Number crossing = floor_of_ratio(
          height + site * site - last.height - last.site * last.site, 2 * (site - last.site));
      first = crossing + 1;
      if (first > last.first) break;
      first = std::numeric_limits<Number>::min();
      --count_;
    }
    parabolas_[count_++] = {site, height, first};
  }
  /// Calls `visit(x, lowest)` for x = `from`, `from` + `step` … < `end`; not at all when empty.
  template <class Visit>
  void each(Number from, Number step, Number end, const Visit& visit) const {
    if (empty()) return;
    std::size_t at = 0;
    for (Number x = from; x < end; x += step) {
      while (at + 1 < count_ && parabolas_[at + 1].first <= x) ++at;
      const Number away = x - parabolas_[at].site;
      visit(x, away * away + parabolas_[at].height);
    }
  }

 private:
  struct Parabola {
    Number site = 0;
    Number height = 0;
    Number first = 0;  ///< From here on it is the lowest.
  };

  static Number floor_of_ratio(Number above, Number below) {  // below > 0
    return above >= 0 ? above / below : -((below - 1 - above) / below);
  }

  std::vector<Parabola> parabolas_;
  std::size_t count_ = 0;
};

}  // namespace eyebridge::mapping
