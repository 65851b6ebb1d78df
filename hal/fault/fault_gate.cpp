#include "fault/fault_gate.hpp"

#include <fmt/format.h>

namespace eyebridge::hal {
namespace {

/// A stream of random numbers of its own for each device: FNV-1a over its name.
std::uint64_t stream_of(std::string_view kind, int id) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : kind) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return hash + static_cast<std::uint64_t>(id);
}

}  // namespace

FaultGate::FaultGate(std::string kind, int id, Clock& clock, const FaultScript& script,
                     std::uint64_t seed)
    : kind_(std::move(kind)),
      id_(id),
      clock_(clock),
      script_(script),
      random_(seed, stream_of(kind_, id)) {}

Result<FaultGate::Verdict> FaultGate::pass() {
  const Time now = clock_.now();
  Verdict verdict = Verdict::Open;
  const auto failed = [&](Errc code, const FaultRule& rule) {
    return fail(code, fmt::format("{} {}: --faults \"{}\"", kind_, id_, rule.text));
  };
  for (const FaultRule& rule : script_) {
    if (!rule.holds(kind_, id_, now)) continue;
    switch (rule.effect) {
      case FaultEffect::Lose:
        return failed(Errc::Disconnected, rule);
      case FaultEffect::Drop: {
        const std::lock_guard lock(random_mutex_);
        if (random_.chance(rule.value)) return failed(Errc::Timeout, rule);
        break;
      }
      case FaultEffect::Freeze:
        verdict = Verdict::Frozen;
        break;
      case FaultEffect::Delay:
        clock_.wait_until(clock_.now() + from_seconds(rule.value));
        break;
    }
  }
  return verdict;
}

}  // namespace eyebridge::hal
