#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "eyebridge/bridges/memory.hpp"
#include "wait.hpp"

namespace eyebridge::bridges {
namespace {

/// One direction: a ring of bytes between a writer and a reader.
class Pipe {
 public:
  explicit Pipe(std::size_t capacity) : ring_(std::max<std::size_t>(capacity, 1)) {}

  /// Bytes taken; 0 when there are none in time, or never will be: see is_closed().
  std::size_t take(std::span<std::uint8_t> buffer, Clock& clock, Time deadline) {
    std::unique_lock lock(mutex_);
    wait_on(changed_, lock, clock, deadline, [&] { return used_ > 0 || closed_; });
    const std::size_t count = std::min(buffer.size(), used_);
    for (std::size_t i = 0; i < count; ++i) {
      buffer[i] = ring_[first_];
      first_ = first_ + 1 == ring_.size() ? 0 : first_ + 1;
    }
    used_ -= count;
    changed_.notify_all();
    return count;
  }

  /// Bytes put: fewer than asked when the pipe stayed full, or is closed.
  std::size_t put(std::span<const std::uint8_t> bytes, Clock& clock, Time deadline) {
    std::unique_lock lock(mutex_);
    std::size_t done = 0;
    while (done < bytes.size()) {
      if (!wait_on(changed_, lock, clock, deadline,
                   [&] { return used_ < ring_.size() || closed_; }) ||
          closed_) {
        break;
      }
      for (; done < bytes.size() && used_ < ring_.size(); ++done, ++used_) {
        ring_[(first_ + used_) % ring_.size()] = bytes[done];
      }
      changed_.notify_all();
    }
    return done;
  }

  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

  [[nodiscard]] bool is_closed() {
    const std::lock_guard lock(mutex_);
    return closed_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::uint8_t> ring_;
  std::size_t first_ = 0;
  std::size_t used_ = 0;
  bool closed_ = false;
};

class MemoryStream final : public ByteStream {
 public:
  MemoryStream(std::shared_ptr<Pipe> in, std::shared_ptr<Pipe> out, Clock& clock)
      : in_(std::move(in)), out_(std::move(out)), clock_(clock) {}
  ~MemoryStream() override { close(); }
  MemoryStream(const MemoryStream&) = delete;
  MemoryStream& operator=(const MemoryStream&) = delete;

  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    if (closed_) return fail(Errc::Disconnected, "memory: closed here");
    const std::size_t count = in_->take(buffer, clock_, deadline);
    if (count > 0) return count;
    if (in_->is_closed()) {
      // What was written between the two looks still counts.
      const std::size_t rest = in_->take(buffer, clock_, Time{0});
      if (rest > 0) return rest;
      return fail(Errc::Disconnected, "memory: closed by the other side");
    }
    return fail(Errc::Timeout, "memory: nothing came in time");
  }

  Result<void> write_all(std::span<const std::uint8_t> bytes, Time deadline) override {
    if (closed_) return fail(Errc::Disconnected, "memory: closed here");
    const std::size_t done = out_->put(bytes, clock_, deadline);
    if (out_->is_closed()) return fail(Errc::Disconnected, "memory: closed by the other side");
    if (done == bytes.size()) return {};
    return fail(Errc::Timeout, "memory: the line took " + std::to_string(done) + " of " +
                                   std::to_string(bytes.size()) + " bytes in time");
  }

  void close() override {
    closed_ = true;
    in_->close();
    out_->close();
  }

  [[nodiscard]] std::string_view name() const override { return "memory"; }

 private:
  std::shared_ptr<Pipe> in_;
  std::shared_ptr<Pipe> out_;
  Clock& clock_;
  bool closed_ = false;
};

}  // namespace

std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> make_memory_streams(
    Clock& clock, std::size_t capacity) {
  return make_memory_streams(clock, clock, capacity);
}

std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> make_memory_streams(
    Clock& first, Clock& second, std::size_t capacity) {
  auto one = std::make_shared<Pipe>(capacity);
  auto other = std::make_shared<Pipe>(capacity);
  return {std::make_unique<MemoryStream>(one, other, first),
          std::make_unique<MemoryStream>(other, one, second)};
}

}  // namespace eyebridge::bridges
