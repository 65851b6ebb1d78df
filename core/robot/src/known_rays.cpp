#include "known_rays.hpp"

#include <algorithm>
#include <cassert>

namespace eyebridge::robot {

std::uint64_t KnownRays::ask(const Moment& moment, std::size_t sensor) {
  assert(sensor < kMost);
  if (!(moment == moment_)) {
    moment_ = moment;
    known_ = 0;
    std::shift_right(asked_.begin(), asked_.end(), 1);
    asked_[0] = 0;
  }
  const std::uint64_t bit = std::uint64_t{1} << sensor;
  asked_[0] |= bit;
  if ((known_ & bit) != 0) return 0;
  std::uint64_t lately = 0;
  for (const std::uint64_t asked : asked_) lately |= asked;
  return lately & ~known_;
}

void KnownRays::keep(std::size_t sensor, double range) {
  if (sensor >= ranges_.size()) ranges_.resize(sensor + 1);
  ranges_[sensor] = range;
  known_ |= std::uint64_t{1} << sensor;
}

}  // namespace eyebridge::robot
