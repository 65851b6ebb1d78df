#include "fault/fault_injector.hpp"

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

FaultInjector::FaultInjector(FaultScript script, Clock& clock, std::uint64_t seed)
    : script_(std::move(script)), clock_(clock), seed_(seed) {}

Result<Values> FaultInjector::exchange(const Call& call,
                                       const std::function<Result<Values>()>& device) {
  const Result<bool> frozen = pass(call);
  if (!frozen) return tl::unexpected(frozen.error());
  if (call.is_command) return *frozen ? Result<Values>(Values{}) : device();

  const std::string key = fmt::format("{} {} {}", call.device, call.id, call.name);
  if (*frozen) {
    const std::lock_guard lock(mutex_);
    const auto last = last_.find(key);
    if (last != last_.end()) return last->second;
  }
  Result<Values> reply = device();
  if (reply) {
    const std::lock_guard lock(mutex_);
    last_[key] = *reply;
  }
  return reply;
}

bool FaultInjector::dropped(const Call& call, double share) {
  const std::lock_guard lock(mutex_);
  const auto [random, is_new] = random_.try_emplace({std::string(call.device), call.id},
                                                    Random(seed_, stream_of(call.device, call.id)));
  return random->second.chance(share);
}

Result<bool> FaultInjector::pass(const Call& call) {
  const Time now = clock_.now();
  bool frozen = false;
  const auto failed = [&](Errc code, const FaultRule& rule) {
    return fail(code, fmt::format("{} {}: --faults \"{}\"", call.device, call.id, rule.text));
  };
  for (const FaultRule& rule : script_) {
    if (!rule.holds(call.device, call.id, now)) continue;
    switch (rule.effect) {
      case FaultEffect::Lose:
        return failed(Errc::Disconnected, rule);
      case FaultEffect::Drop:
        if (dropped(call, rule.value)) return failed(Errc::Timeout, rule);
        break;
      case FaultEffect::Freeze:
        frozen = true;
        break;
      case FaultEffect::Delay:
        clock_.wait_until(clock_.now() + from_seconds(rule.value));
        break;
    }
  }
  return frozen;
}

std::unique_ptr<Backend> with_faults(std::unique_ptr<Backend> inner, FaultScript script,
                                     std::uint64_t seed) {
  return with_interceptor(std::move(inner), [&](Backend& backend) {
    return std::make_unique<FaultInjector>(std::move(script), backend.clock(), seed);
  });
}

}  // namespace eyebridge::hal
