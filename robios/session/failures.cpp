#include "failures.hpp"

#include <utility>

namespace eyebridge::robios {

bool Failures::add(std::string_view call, const Error& error) {
  const std::lock_guard lock(mutex_);
  last_ = std::string(call) + ": " + error.what;
  Seen& seen = calls_[std::string(call)];
  if (error.code == Errc::OutOfRange || error.code == Errc::Unsupported ||
      error.code == Errc::NoDevice) {
    return seen.mistakes.size() < kMostMistakes && seen.mistakes.insert(error.what).second;
  }
  any_lost_ = true;
  return !std::exchange(seen.lost, true);
}

void Failures::succeeded(std::string_view call) {
  if (!any_lost_) return;
  const std::lock_guard lock(mutex_);
  const auto found = calls_.find(call);
  if (found != calls_.end()) found->second.lost = false;
}

std::string Failures::last() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

}  // namespace eyebridge::robios
