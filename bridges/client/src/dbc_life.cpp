// What happens between a program and a robot with its own messages without being asked for.
#include <algorithm>
#include <utility>

#include <pthread.h>

#include "eyebridge/bridges/can_socket_bytes.hpp"
#include "eyebridge/bridges/client/dbc_client.hpp"
#include "eyebridge/bridges/dbc/signal.hpp"
#include "pump_bus.hpp"

namespace eyebridge::bridges {
namespace {

using namespace std::chrono_literals;

/// How long the thread waits for a frame at most.
constexpr Time kLongestWait = 50ms;
constexpr Time kSendPatience = 5ms;
constexpr Time kWaitStep = 5ms;
/// Of the counters of one command, for its guard.
constexpr std::uint64_t kGuardedCounters = 16;

}  // namespace

void DbcClient::start() {
  thread_ = std::thread([this] { run(); });
  // By this name robios knows that it is none of the program's own threads.
  pthread_setname_np(thread_.native_handle(), "eb:dbc");
}

void DbcClient::run() {
  while (true) {
    {
      const std::lock_guard lock(mutex_);
      if (ending_) return;
    }
    pump(clock_.now() + kLongestWait);
  }
}

void DbcClient::pump(Time until) {
  pump_bus(
      *bus_, clock_, until, [this] { return tick(); },
      [this](const CanFrame& frame) { take(frame); },
      [this](const std::string& why) {
        const std::lock_guard lock(mutex_);
        check_heartbeat(Time::max(), why);
      });
}

Time DbcClient::tick() {
  const std::lock_guard sending(sending_);
  std::vector<CanFrame> frames;
  Time next = Time::max();
  bool turning = false;
  {
    const std::lock_guard lock(mutex_);
    const Time now = clock_.now();
    check_heartbeat(now, "");
    next = now + kLongestWait;
    for (std::size_t i = 0; phase_ != Phase::Unheard && i < senders_.size(); ++i) {
      Sender& sender = senders_[i];
      const Time period = plan_.commands[i].period;
      if (now >= sender.due) {
        frames.push_back(next_frame(i));
        // What was missed is not made up for.
        sender.due = now - sender.due < period ? sender.due + period : now + period;
      }
      next = std::min(next, sender.due);
    }
    turning = is_turning();
  }
  if (turning) tell_guard(true);
  for (const CanFrame& frame : frames) {
    // That the bus does not work, receive() says too.
    (void)bus_->send(frame, clock_.now() + kSendPatience);
  }
  return next;
}

CanFrame DbcClient::next_frame(std::size_t command) {
  Sender& sender = senders_[command];
  sender.counter = next_counter(plan_.commands[command], sender.counter);
  return dbc_frame(plan_.commands[command], sender.bytes, sender.counter);
}

void DbcClient::rest() {
  for (std::size_t i = 0; i < senders_.size(); ++i) senders_[i].bytes = plan_.commands[i].resting;
}

/// `why` is what is wrong with the bus, else empty.
void DbcClient::check_heartbeat(Time now, const std::string& why) {
  if (phase_ != Phase::Ready || (why.empty() && now - heard_ <= plan_.heartbeat_limit)) return;
  phase_ = Phase::Lost;
  ++generation_;
  rest();
  const auto limit = std::chrono::duration_cast<std::chrono::milliseconds>(plan_.heartbeat_limit);
  trouble_ = why.empty() ? "has not sent " + plan_.statuses[plan_.heartbeat].name + " for " +
                               std::to_string(limit.count()) + " ms"
                         : "is lost: " + why;
  log_.write(Severity::Error, who_ + " " + trouble_);
  changed_.notify_all();
}

void DbcClient::take(const CanFrame& frame) {
  const std::lock_guard lock(mutex_);
  const Time now = clock_.now();
  for (std::size_t i = 0; i < plan_.readings.size(); ++i) {
    const DbcReading& reading = plan_.readings[i];
    const dbc::Message& message = plan_.statuses[reading.status];
    if (!is_of(message, frame)) continue;
    if (!dbc::is_present(message, reading.signal, frame.bytes())) continue;
    const std::uint64_t bits = dbc::raw_bits(message.signals[reading.signal], frame.bytes());
    Latest& entry = latest_[i];
    if (!entry.at || bits != entry.bits) entry.changed = now;
    entry.bits = bits;
    entry.at = now;
  }
  if (is_of(plan_.statuses[plan_.heartbeat], frame)) {
    heard_ = now;
    if (phase_ != Phase::Ready) log_.write(Severity::Info, who_ + " is heard");
    phase_ = Phase::Ready;
  }
  changed_.notify_all();
}

bool DbcClient::wait_for(const std::function<bool()>& done, Time deadline) {
  if (!thread_.joinable()) {
    while (true) {
      {
        const std::lock_guard lock(mutex_);
        if (done()) return true;
      }
      if (clock_.now() >= deadline) return false;
      pump(std::min(deadline, clock_.now() + kWaitStep));
    }
  }
  std::unique_lock lock(mutex_);
  while (!done()) {
    const Time left = deadline - clock_.now();
    if (left <= Time{0}) return false;
    changed_.wait_for(lock, left);
  }
  return true;
}

StopOrders DbcClient::stop_orders() const {
  StopOrders orders;
  std::vector<std::size_t> commands;
  for (const DbcSetPoint& wheel : plan_.wheels) commands.push_back(wheel.command);
  std::ranges::sort(commands);
  commands.erase(std::unique(commands.begin(), commands.end()), commands.end());
  for (const std::size_t index : commands) {
    const DbcCommand& command = plan_.commands[index];
    const std::uint64_t last = command.counter ? command.counter->last : 0;
    for (std::uint64_t counter = 0; counter <= std::min(last, kGuardedCounters - 1); ++counter) {
      if (orders.count == orders.writes.size()) break;
      const CanFrame frame = dbc_frame(command, command.resting, counter);
      (void)orders.writes[orders.count++].add(socket_bytes(frame).view());
    }
  }
  orders.frames = true;
  orders.has_watchdog = plan_.has_watchdog;
  if (!plan_.stopped) return orders;
  const DbcReading& reading = plan_.readings[*plan_.stopped];
  const dbc::Message& message = plan_.statuses[reading.status];
  CanFrame answer{.id = message.id, .length = static_cast<std::uint8_t>(message.length)};
  answer.extended = message.extended;
  answer.fd = message.fd;
  CanFrame mask = answer;
  dbc::put_bits(message.signals[reading.signal], plan_.stopped_bits, answer.data);
  dbc::put_bits(message.signals[reading.signal], ~std::uint64_t{0}, mask.data);
  (void)orders.answer.add(socket_bytes(answer).view());
  (void)orders.mask.add(socket_bytes(mask).view());
  // Identifier and length count, whatever the kernel has between them and the data.
  std::fill_n(orders.mask.bytes.begin(), 5, 0xFF);
  std::fill_n(orders.mask.bytes.begin() + 5, 3, 0x00);
  return orders;
}

Result<void> DbcClient::guard() {
  if (bus_->descriptor() < 0) {
    return fail(Errc::Unsupported, std::string(bus_->name()) + ": a bus that cannot be guarded");
  }
  auto started = LineGuard::start();
  if (!started) return tl::unexpected(std::move(started.error()));
  const std::lock_guard sending(sending_);
  guard_ = std::move(*started);
  return guard_->hold(bus_->descriptor(), who_, stop_orders());
}

void DbcClient::tell_guard(bool turning) {
  if (guard_ == nullptr) return;
  if (turning ? guard_->turning(clock_.now()) : guard_->still()) return;
  guard_.reset();
  log_.write(Severity::Error,
             who_ + ": its guard was ended: nothing but itself stops it if the program crashes");
}

}  // namespace eyebridge::bridges
