// What a program asks of a robot with its own messages. What happens by itself is in dbc_life.cpp.
#include "eyebridge/bridges/client/dbc_client.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "eyebridge/bridges/dbc/signal.hpp"

namespace eyebridge::bridges {
namespace {

using namespace std::chrono_literals;

constexpr Time kStopPatience = 1s;
constexpr Time kYoungest = 300ms;
constexpr Time kUnknownAge = 1s;
constexpr Time kFinalSend = 5ms;
/// A wheel that has not moved for so long stands.
constexpr Time kStanding = 50ms;

Time oldest_allowed(const dbc::Message& message) {
  if (!message.period_ms) return kUnknownAge;
  return std::max<Time>(kYoungest, 4 * std::chrono::milliseconds(*message.period_ms));
}

}  // namespace

DbcClient::DbcClient(std::unique_ptr<CanBus> bus, DbcPlan plan, Clock& clock, LogSink& log)
    : bus_(std::move(bus)),
      plan_(std::move(plan)),
      who_(std::string(bus_->name()) + ": " + plan_.robot),
      clock_(clock),
      log_(log),
      trouble_("not heard yet; expected " + plan_.statuses.at(plan_.heartbeat).name),
      latest_(plan_.readings.size()) {
  for (const DbcCommand& command : plan_.commands) senders_.push_back({command.resting, 0, {}});
  std::vector<CanFilter> own;
  for (const dbc::Message& status : plan_.statuses) {
    const std::uint32_t mask =
        status.extended ? CanFrame::kMaxExtendedId : CanFrame::kMaxStandardId;
    own.push_back({.id = status.id, .mask = mask, .extended = status.extended});
  }
  // Refused only by buses that cannot filter: then take() does it.
  (void)bus_->set_filters(own);
}

DbcClient::~DbcClient() {
  {
    const std::lock_guard sending(sending_);
    std::vector<CanFrame> last;
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
      const bool turning = is_turning();
      rest();
      for (std::size_t i = 0; turning && i < senders_.size(); ++i) last.push_back(next_frame(i));
    }
    for (const CanFrame& frame : last) (void)bus_->send(frame, clock_.now() + kFinalSend);
  }
  if (thread_.joinable()) thread_.join();
}

Result<void> DbcClient::check_ready() const {
  if (phase_ == Phase::Ready) return {};
  return fail(Errc::Disconnected, who_ + " " + trouble_);
}

bool DbcClient::is_turning() const {
  for (std::size_t i = 0; i < senders_.size(); ++i) {
    if (senders_[i].bytes != plan_.commands[i].resting) return true;
  }
  return false;
}

Result<void> DbcClient::wheel(std::size_t index, double value) {
  assert(index < plan_.wheels.size());
  const DbcSetPoint& point = plan_.wheels[index];
  const dbc::Signal& signal = plan_.commands[point.command].message.signals[point.signal];
  const auto bits = dbc::bits_for(signal, value);
  if (!bits) return tl::unexpected(bits.error());
  const std::lock_guard sending(sending_);
  bool turning = false;
  {
    const std::lock_guard lock(mutex_);
    if (auto ready = check_ready(); !ready) return ready;
    dbc::put_bits(signal, *bits, senders_[point.command].bytes);
    turning = is_turning();
  }
  if (turning) tell_guard(true);
  return {};
}

Result<DbcValue> DbcClient::latest(std::size_t index) const {
  assert(index < plan_.readings.size());
  const DbcReading& reading = plan_.readings[index];
  const dbc::Message& message = plan_.statuses[reading.status];
  const dbc::Signal& signal = message.signals[reading.signal];
  const std::lock_guard lock(mutex_);
  if (auto ready = check_ready(); !ready) return tl::unexpected(ready.error());
  const Latest& entry = latest_[index];
  if (!entry.at || clock_.now() - *entry.at > oldest_allowed(message)) {
    return fail(Errc::Timeout, who_ + " sends no " + message.name + "." + signal.name);
  }
  if (reading.invalid == entry.bits) {
    return fail(Errc::Unsupported, who_ + " has no value for " + message.name + "." + signal.name);
  }
  return DbcValue{dbc::whole_number(signal, entry.bits), dbc::value_of(signal, entry.bits),
                  *entry.at};
}

bool DbcClient::stands_since(Time told) const {
  if (plan_.stopped) {
    const Latest& entry = latest_[*plan_.stopped];
    return entry.at && *entry.at > told && entry.bits == plan_.stopped_bits;
  }
  return std::ranges::all_of(plan_.still, [&](std::size_t index) {
    const Latest& entry = latest_[index];
    return entry.at && *entry.at > told && *entry.at - entry.changed >= kStanding;
  });
}

Result<void> DbcClient::stop() {
  Time told{0};
  {
    const std::lock_guard sending(sending_);
    std::vector<CanFrame> frames;
    {
      const std::lock_guard lock(mutex_);
      // A robot that was never ours is none of our business.
      if (phase_ == Phase::Unheard) return {};
      rest();
      for (const DbcSetPoint& wheel : plan_.wheels) {
        const bool is_there = std::ranges::any_of(frames, [&](const CanFrame& frame) {
          return is_of(plan_.commands[wheel.command].message, frame);
        });
        if (!is_there) frames.push_back(next_frame(wheel.command));
      }
    }
    for (const CanFrame& frame : frames) {
      if (auto sent = bus_->send(frame, clock_.now() + kFinalSend); !sent) return sent;
    }
    told = clock_.now();
  }
  Result<void> ready;
  const bool seen = wait_for([&] { return !(ready = check_ready()) || stands_since(told); },
                             told + kStopPatience);
  if (!ready) return ready;
  if (!seen) {
    return fail(Errc::Timeout, who_ + " was told to stop, and does not show that it stands");
  }
  const std::lock_guard sending(sending_);
  const bool turns = [this] {
    const std::lock_guard lock(mutex_);
    return is_turning();
  }();
  if (!turns) tell_guard(false);
  return {};
}

std::string DbcClient::missing() const {
  if (auto ready = check_ready(); !ready) return ready.error().what;
  std::string names;
  for (std::size_t i = 0; i < latest_.size(); ++i) {
    const dbc::Message& message = plan_.statuses[plan_.readings[i].status];
    const std::string name = message.name + "." + message.signals[plan_.readings[i].signal].name;
    if (!latest_[i].at) names += (names.empty() ? "" : ", ") + name;
  }
  return names.empty() ? "" : who_ + " does not send " + names;
}

Result<void> DbcClient::wait_ready(Time patience) {
  std::string left;
  if (wait_for([&] { return (left = missing()).empty(); }, clock_.now() + patience)) return {};
  const std::lock_guard lock(mutex_);
  if (auto not_ready = check_ready(); !not_ready) return not_ready;
  return fail(Errc::Timeout, left);
}

std::uint32_t DbcClient::generation() const {
  const std::lock_guard lock(mutex_);
  return generation_;
}

}  // namespace eyebridge::bridges
