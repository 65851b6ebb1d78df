#include "eyebridge/bridges/faulty_stream.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "fault_engine.hpp"

namespace eyebridge::bridges {
namespace {

/// A chunk after its faults: the parts that it falls into, each late or not.
struct Damaged {
  struct Part {
    std::vector<std::uint8_t> bytes;
    bool late = false;
  };
  std::vector<Part> parts;
  bool unplug = false;
};

Damaged damage(FaultEngine& engine, std::span<const std::uint8_t> bytes) {
  Damaged result;
  result.parts.push_back({{}, engine.next_chunk_is_late()});
  for (const std::uint8_t byte : bytes) {
    const Fate fate = engine.next(8);
    if (fate.unplug) {
      result.unplug = true;
      break;
    }
    const bool inside = !result.parts.back().bytes.empty();
    if (inside && (fate.split || fate.delay)) {
      if (fate.split) engine.count(&FaultCounts::split);
      result.parts.push_back({});
    }
    if (fate.delay) result.parts.back().late = true;
    if (fate.drop) continue;
    const auto changed =
        static_cast<std::uint8_t>(fate.flip ? byte ^ (1U << *fate.flip) : unsigned{byte});
    result.parts.back().bytes.insert(result.parts.back().bytes.end(), fate.repeat ? 2 : 1, changed);
  }
  std::erase_if(result.parts, [](const Damaged::Part& part) { return part.bytes.empty(); });
  for (const Damaged::Part& part : result.parts) {
    if (part.late) engine.count(&FaultCounts::delayed);
  }
  return result;
}

}  // namespace

FaultyStream::FaultyStream(std::unique_ptr<ByteStream> inner, const FaultPlan& plan, Clock& clock)
    : inner_(std::move(inner)),
      clock_(clock),
      incoming_(std::make_unique<FaultEngine>(plan.incoming, plan.seed, 0)),
      outgoing_(std::make_unique<FaultEngine>(plan.outgoing, plan.seed, 1)) {}

FaultyStream::~FaultyStream() { close(); }

Result<std::size_t> FaultyStream::read_some(std::span<std::uint8_t> buffer, Time deadline) {
  assert(!buffer.empty());
  // A writer at work flushes itself; waiting for him would stop a line that is full both ways.
  if (const std::unique_lock lock(writing_, std::try_to_lock); lock) {
    if (auto flushed = flush(deadline); !flushed) {
      return tl::unexpected(std::move(flushed.error()));
    }
  }
  while (arrived_.empty()) {
    if (auto fetched = fetch(deadline); !fetched) {
      return tl::unexpected(std::move(fetched.error()));
    }
  }
  Chunk& chunk = arrived_.front();
  clock_.wait_until(std::min(chunk.due, deadline));
  if (clock_.now() < chunk.due) {
    return fail(Errc::Timeout, std::string(name()) + ": nothing came in time");
  }
  const std::size_t count = std::min(buffer.size(), chunk.bytes.size());
  const auto end = chunk.bytes.begin() + static_cast<std::ptrdiff_t>(count);
  std::copy(chunk.bytes.begin(), end, buffer.begin());
  chunk.bytes.erase(chunk.bytes.begin(), end);
  if (chunk.bytes.empty()) arrived_.pop_front();
  return count;
}

Result<void> FaultyStream::fetch(Time deadline) {
  std::array<std::uint8_t, 4096> raw;
  auto count = inner_->read_some(raw, deadline);
  if (!count) return tl::unexpected(std::move(count.error()));
  if (incoming_->next_chunk_is_merged() && *count < raw.size()) {
    const auto more = inner_->read_some(std::span(raw).subspan(*count), clock_.now());
    if (more) {
      incoming_->count(&FaultCounts::merged);
      *count += *more;
    }
  }
  Damaged damaged = damage(*incoming_, std::span(raw).first(*count));
  for (Damaged::Part& part : damaged.parts) {
    const Time due = part.late ? clock_.now() + incoming_->delay_by() : Time{};
    arrived_.push_back({std::move(part.bytes), due});
  }
  if (damaged.unplug) {
    inner_->close();
    if (arrived_.empty()) return unplugged();
  }
  return {};
}

Result<void> FaultyStream::write_all(std::span<const std::uint8_t> bytes, Time deadline) {
  const std::lock_guard lock(writing_);
  Damaged damaged = damage(*outgoing_, bytes);
  const bool merged = outgoing_->next_chunk_is_merged();
  for (const Damaged::Part& part : damaged.parts) {
    if (part.late) clock_.wait_until(clock_.now() + outgoing_->delay_by());
    held_back_.insert(held_back_.end(), part.bytes.begin(), part.bytes.end());
    const bool last = &part == &damaged.parts.back();
    if (last && merged && !damaged.unplug) {
      outgoing_->count(&FaultCounts::merged);
      return {};
    }
    if (auto flushed = flush(deadline); !flushed) return flushed;
  }
  if (damaged.unplug) {
    inner_->close();
    return unplugged();
  }
  // Dropped or not: on a line that is closed even nothing cannot be written.
  return damaged.parts.empty() ? inner_->write_all({}, deadline) : Result<void>{};
}

Result<void> FaultyStream::flush(Time deadline) {
  if (held_back_.empty()) return {};
  const std::vector<std::uint8_t> bytes = std::exchange(held_back_, {});
  return inner_->write_all(bytes, deadline);
}

void FaultyStream::close() {
  {
    const std::lock_guard lock(writing_);
    // Nobody is told when this fails: the line is being given up.
    static_cast<void>(flush(clock_.now()));
  }
  arrived_.clear();
  inner_->close();
}

tl::unexpected<Error> FaultyStream::unplugged() const {
  return fail(Errc::Disconnected, std::string(name()) + ": unplugged by the fault script");
}

FaultCounts FaultyStream::counts() const { return incoming_->counts() + outgoing_->counts(); }

}  // namespace eyebridge::bridges
