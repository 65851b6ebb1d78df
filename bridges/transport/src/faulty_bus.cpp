#include "eyebridge/bridges/faulty_bus.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "fault_engine.hpp"

namespace eyebridge::bridges {
namespace {

void flip_bit(CanFrame& frame, unsigned bit) {
  frame.data[bit / 8] = static_cast<std::uint8_t>(frame.data[bit / 8] ^ (1U << bit % 8));
}

unsigned bits_of(const CanFrame& frame) { return static_cast<unsigned>(8 * frame.bytes().size()); }

}  // namespace

FaultyBus::FaultyBus(std::unique_ptr<CanBus> inner, const FaultPlan& plan, Clock& clock)
    : inner_(std::move(inner)),
      clock_(clock),
      incoming_(std::make_unique<FaultEngine>(plan.incoming, plan.seed, 0)),
      outgoing_(std::make_unique<FaultEngine>(plan.outgoing, plan.seed, 1)) {}

FaultyBus::~FaultyBus() = default;

Result<void> FaultyBus::send(const CanFrame& frame, Time deadline) {
  if (unplugged_) return unplugged();
  if (const char* wrong = why_not_sendable(frame)) {
    return fail(Errc::OutOfRange, std::string(name()) + ": " + wrong);
  }
  const Fate fate = outgoing_->next(bits_of(frame));
  if (fate.unplug) {
    unplugged_ = true;
    return unplugged();
  }
  if (outgoing_->next_chunk_is_late() || fate.delay) {
    outgoing_->count(&FaultCounts::delayed);
    clock_.wait_until(clock_.now() + outgoing_->delay_by());
  }
  CanFrame changed = frame;
  if (fate.flip) flip_bit(changed, *fate.flip);
  for (int copies = fate.drop ? 0 : fate.repeat ? 2 : 1; copies > 0; --copies) {
    if (auto done = inner_->send(changed, deadline); !done) return done;
  }
  ++sent_;
  return {};
}

Result<CanFrame> FaultyBus::receive(Time deadline) {
  while (arrived_.empty()) {
    if (unplugged_) return unplugged();
    auto frame = inner_->receive(deadline);
    if (!frame) return frame;
    const Fate fate = incoming_->next(bits_of(*frame));
    if (fate.unplug) {
      unplugged_ = true;
      continue;
    }
    if (fate.flip) flip_bit(*frame, *fate.flip);
    const bool late = (incoming_->next_chunk_is_late() || fate.delay) && !fate.drop;
    if (late) incoming_->count(&FaultCounts::delayed);
    const Time due = late ? clock_.now() + incoming_->delay_by() : Time{};
    for (int copies = fate.drop ? 0 : fate.repeat ? 2 : 1; copies > 0; --copies) {
      arrived_.push_back({*frame, due});
    }
  }
  clock_.wait_until(std::min(arrived_.front().due, deadline));
  if (clock_.now() < arrived_.front().due) {
    return fail(Errc::Timeout, std::string(name()) + ": no frame came in time");
  }
  const CanFrame frame = arrived_.front().frame;
  arrived_.pop_front();
  ++received_;
  return frame;
}

CanStatistics FaultyBus::statistics() const {
  CanStatistics statistics = inner_->statistics();
  statistics.sent = sent_;
  statistics.received = received_;
  return statistics;
}

tl::unexpected<Error> FaultyBus::unplugged() const {
  return fail(Errc::Disconnected, std::string(name()) + ": unplugged by the fault script");
}

FaultCounts FaultyBus::counts() const { return incoming_->counts() + outgoing_->counts(); }

}  // namespace eyebridge::bridges
