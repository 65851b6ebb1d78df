#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

#include "eyebridge/base/result.hpp"

namespace eyebridge::robios {

/// Remembers which calls failed, so that a loop that fails a thousand times is reported once.
///
/// A mistake of the program (OutOfRange, Unsupported, NoDevice) is reported once for each reason,
/// and at most kMostMistakes of them for one call; a lost device once until the call works again.
/// Any thread.
class Failures {
 public:
  static constexpr std::size_t kMostMistakes = 5;

  /// True when this failure should be shown.
  bool add(std::string_view call, const Error& error);
  void succeeded(std::string_view call);
  /// "CALL: reason" of the last one, or "".
  [[nodiscard]] std::string last() const;

 private:
  struct Seen {
    std::set<std::string> mistakes;
    bool lost = false;
  };

  std::atomic<bool> any_lost_ = false;  ///< Spares succeeded() the lock.
  mutable std::mutex mutex_;
  std::map<std::string, Seen, std::less<>> calls_;
  std::string last_;
};

}  // namespace eyebridge::robios
