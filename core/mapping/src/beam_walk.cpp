#include "beam_walk.hpp"

#include <algorithm>

namespace eyebridge::mapping {
namespace {

/// Quotient rounded down; `divisor` > 0.
std::int64_t down(std::int64_t value, std::int64_t divisor) {
  const std::int64_t quotient = value / divisor;
  return quotient * divisor > value ? quotient - 1 : quotient;
}

std::int64_t up(std::int64_t value, std::int64_t divisor) { return -down(-value, divisor); }

}  // namespace

void BeamWalk::clip(const Box& box, int& from, int& to) const {
  std::int64_t low = from;
  std::int64_t high = to;
  const std::int64_t along = steep_ ? box.rows : box.columns;
  // 0 <= first + step * k < along
  if (step_ > 0) {
    low = std::max(low, -first_);
    high = std::min(high, along - first_);
  } else {
    low = std::max(low, first_ - (along - 1));
    high = std::min(high, first_ + 1);
  }
  // 0 <= across + slope * k <= most
  const std::int64_t most = (std::int64_t{steep_ ? box.columns : box.rows} << kBits) - 1;
  if (slope_ > 0) {
    low = std::max(low, up(-across_, slope_));
    high = std::min(high, down(most - across_, slope_) + 1);
  } else if (slope_ < 0) {
    low = std::max(low, up(across_ - most, -slope_));
    high = std::min(high, down(across_, -slope_) + 1);
  } else if (across_ < 0 || across_ > most) {
    high = low;
  }
  high = std::max(low, high);
  if (low >= to || high <= from) {
    to = from;
    return;
  }
  from = static_cast<int>(low);
  to = static_cast<int>(high);
}

}  // namespace eyebridge::mapping
