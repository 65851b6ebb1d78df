#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/result.hpp"
#include "fault/fault_script.hpp"

namespace eyebridge::hal {

/// Lets the calls of one device through, or not, as the script says. Any thread.
class FaultGate {
 public:
  /// `kind` and `id` as rules name the device; `clock` and `script` are lent. What is dropped by
  /// chance follows from `seed`, the kind and the id alone.
  FaultGate(std::string kind, int id, Clock& clock, const FaultScript& script, std::uint64_t seed);

  /// What `read` gives, or what it gave before the device froze.
  template <class Value, class Read>
  Result<Value> reading(std::optional<Value>& last, Read&& read) {
    const Result<Verdict> verdict = pass();
    if (!verdict) return tl::unexpected(verdict.error());
    const std::lock_guard lock(reading_mutex_);
    if (*verdict == Verdict::Frozen && last) return *last;
    Result<Value> value = read();
    if (value) last = *value;
    return value;
  }

  /// What `carry_out` says; frozen devices take commands without doing anything.
  template <class CarryOut>
  Result<void> command(CarryOut&& carry_out) {
    const Result<Verdict> verdict = pass();
    if (!verdict) return tl::unexpected(verdict.error());
    if (*verdict == Verdict::Frozen) return {};
    return carry_out();
  }

 private:
  enum class Verdict { Open, Frozen };

  /// Waits as the script says. Fails with Disconnected or Timeout.
  Result<Verdict> pass();

  std::string kind_;
  int id_;
  Clock& clock_;
  const FaultScript& script_;
  std::mutex random_mutex_;
  Random random_;
  std::mutex reading_mutex_;
};

}  // namespace eyebridge::hal
