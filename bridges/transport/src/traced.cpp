#include <mutex>
#include <string>
#include <utility>

#include "eyebridge/bridges/trace.hpp"

namespace eyebridge::bridges {
namespace {

/// Puts the lines of a reader and a writer one behind the other.
class Log {
 public:
  Log(Clock& clock, TraceSink sink) : clock_(clock), sink_(std::move(sink)) {}

  template <class Record>
  void put(Record record) {
    const std::lock_guard lock(mutex_);
    record.time = clock_.now();
    sink_(to_line(record));
  }

 private:
  Clock& clock_;
  TraceSink sink_;
  std::mutex mutex_;
};

class TracedStream final : public ByteStream {
 public:
  TracedStream(std::unique_ptr<ByteStream> inner, Clock& clock, TraceSink sink)
      : inner_(std::move(inner)), log_(clock, std::move(sink)) {}

  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    auto count = inner_->read_some(buffer, deadline);
    if (count) put(Direction::In, buffer.first(*count));
    return count;
  }
  Result<void> write_all(std::span<const std::uint8_t> bytes, Time deadline) override {
    // Before it goes out: the answer must not come first.
    if (!bytes.empty()) put(Direction::Out, bytes);
    return inner_->write_all(bytes, deadline);
  }
  void close() override { inner_->close(); }
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }

 private:
  void put(Direction direction, std::span<const std::uint8_t> bytes) {
    log_.put(ByteRecord{{}, direction, {bytes.begin(), bytes.end()}});
  }

  std::unique_ptr<ByteStream> inner_;
  Log log_;
};

/// A bus may be called anything; in a trace its name is one printable word.
std::string as_word(std::string_view name) {
  std::string word(name);
  for (char& c : word) {
    if (c <= 0x20 || c >= 0x7F) c = '_';
  }
  return word.empty() ? "can" : word;
}

class TracedBus final : public CanBus {
 public:
  TracedBus(std::unique_ptr<CanBus> inner, Clock& clock, TraceSink sink)
      : inner_(std::move(inner)),
        interface_(as_word(inner_->name())),
        log_(clock, std::move(sink)) {}

  Result<void> send(const CanFrame& frame, Time deadline) override {
    if (why_not_sendable(frame) == nullptr) put(Direction::Out, frame);
    return inner_->send(frame, deadline);
  }
  Result<CanFrame> receive(Time deadline) override {
    auto frame = inner_->receive(deadline);
    if (frame) put(Direction::In, *frame);
    return frame;
  }
  Result<void> set_filters(std::span<const CanFilter> filters) override {
    return inner_->set_filters(filters);
  }
  [[nodiscard]] CanStatistics statistics() const override { return inner_->statistics(); }
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }

 private:
  void put(Direction direction, const CanFrame& frame) {
    log_.put(CanRecord{{}, interface_, frame, direction});
  }

  std::unique_ptr<CanBus> inner_;
  const std::string interface_;
  Log log_;
};

}  // namespace

std::unique_ptr<ByteStream> make_traced(std::unique_ptr<ByteStream> inner, Clock& clock,
                                        TraceSink sink) {
  return std::make_unique<TracedStream>(std::move(inner), clock, std::move(sink));
}

std::unique_ptr<CanBus> make_traced(std::unique_ptr<CanBus> inner, Clock& clock, TraceSink sink) {
  return std::make_unique<TracedBus>(std::move(inner), clock, std::move(sink));
}

}  // namespace eyebridge::bridges
