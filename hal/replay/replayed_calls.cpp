#include "replay/replayed_calls.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "replay/numbers.hpp"

namespace eyebridge::hal {
namespace {

std::string name_of(std::string_view device, int id, std::string_view call) {
  return fmt::format("{} {} {}", device, id, call);
}

std::string shown(const std::string& name, const Values& request) {
  return request.empty() ? name : fmt::format("{} ({})", name, write_numbers(request));
}

/// A request that is no number is one, too: it was refused then as now.
bool is_same(const Values& one, const Values& other) {
  return std::ranges::equal(
      one, other, [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

}  // namespace

StrictReplay::StrictReplay(std::vector<Exchange> exchanges, Clock& clock, LogSink& log)
    : exchanges_(std::move(exchanges)), clock_(clock), log_(log) {}

Result<Values> StrictReplay::exchange(const Call& call,
                                      const std::function<Result<Values>()>& device) {
  const std::lock_guard lock(mutex_);
  if (!deviation_.empty()) return fail(Errc::Corrupt, deviation_);
  const std::string name = name_of(call.device, call.id, call.name);
  const Exchange* then = next_ < exchanges_.size() ? &exchanges_[next_] : nullptr;
  const bool same = then != nullptr && name == name_of(then->device, then->id, then->name) &&
                    is_same(call.request, then->request);
  if (!same) {
    const std::string expected =
        then == nullptr ? std::string("its end")
                        : shown(name_of(then->device, then->id, then->name), then->request);
    deviation_ =
        fmt::format("replay: at {:.3f} s, exchange {}: the program calls {}, the recording has {}",
                    to_seconds(then == nullptr ? clock_.now() : then->time), next_ + 1,
                    shown(name, call.request), expected);
    log_.write(Severity::Error, deviation_);
    return fail(Errc::Corrupt, deviation_);
  }
  ++next_;
  clock_.wait_until(then->time);
  // There is nothing behind it, but a lidar that keeps the shape of its scans.
  if (call.is_command && then->reply) (void)device();
  return then->reply;
}

void StrictReplay::finish() noexcept {
  const std::lock_guard lock(mutex_);
  if (std::exchange(finished_, true) || !deviation_.empty() || next_ == exchanges_.size()) return;
  log_.write(Severity::Warning,
             fmt::format("replay: the program has ended after {} of {} recorded exchanges", next_,
                         exchanges_.size()));
}

LenientReplay::LenientReplay(const std::vector<Exchange>& exchanges, Clock& clock) : clock_(clock) {
  for (const Exchange& e : exchanges) {
    readings_[name_of(e.device, e.id, e.name)].insert_or_assign(e.time, e.reply);
  }
}

Result<Values> LenientReplay::exchange(const Call& call,
                                       const std::function<Result<Values>()>& device) {
  if (call.is_command) {
    (void)device();  // for a lidar, as in a strict replay
    return Values{};
  }
  const std::string name = name_of(call.device, call.id, call.name);
  const auto replies = readings_.find(name);
  if (replies == readings_.end()) {
    return fail(Errc::Unsupported, fmt::format("replay: the recording has no {}", name));
  }
  const auto later = replies->second.upper_bound(clock_.now());
  return (later == replies->second.begin() ? later : std::prev(later))->second;
}

}  // namespace eyebridge::hal
