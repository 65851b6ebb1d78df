#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "eyebridge/bridges/replay.hpp"
#include "replay_cursors.hpp"
#include "wait.hpp"

namespace eyebridge::bridges {
namespace {

class ReplayStream final : public ByteStream {
 public:
  ReplayStream(std::vector<ByteRecord> records, std::string name, ReplayMode mode, Clock& clock)
      : cursors_(std::move(records), mode), name_(std::move(name)), clock_(clock) {}

  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    std::unique_lock lock(mutex_);
    wait_on(changed_, lock, clock_, deadline,
            [&] { return cursors_.is_readable() || cursors_.is_over() || closed_; });
    if (closed_) return fail(Errc::Disconnected, name_ + ": closed here");
    if (cursors_.is_over()) return fail(Errc::Disconnected, name_ + ": the trace ends here");
    if (!cursors_.is_readable()) return fail(Errc::Timeout, name_ + ": nothing came in time");
    const auto rest = std::span(cursors_.next_in()->bytes).subspan(read_);
    const std::size_t count = std::min(buffer.size(), rest.size());
    std::copy_n(rest.begin(), count, buffer.begin());
    read_ += count;
    if (count == rest.size()) {
      cursors_.step_in();
      read_ = 0;
    }
    return count;
  }

  Result<void> write_all(std::span<const std::uint8_t> bytes, Time) override {
    const std::lock_guard lock(mutex_);
    if (closed_) return fail(Errc::Disconnected, name_ + ": closed here");
    if (!cursors_.is_strict()) return {};
    for (const std::uint8_t byte : bytes) {
      const ByteRecord* expected = cursors_.next_out();
      if (expected == nullptr) {
        return fail(Errc::Disconnected, name_ + ": the trace has nothing more that was sent");
      }
      if (expected->bytes[written_] != byte) return deviation(*expected, bytes);
      if (++written_ == expected->bytes.size()) {
        cursors_.step_out();
        written_ = 0;
      }
    }
    changed_.notify_all();
    return {};
  }

  void close() override {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  [[nodiscard]] std::string_view name() const override { return name_; }

 private:
  [[nodiscard]] tl::unexpected<Error> deviation(const ByteRecord& expected,
                                                std::span<const std::uint8_t> bytes) const {
    const ByteRecord found{expected.time, Direction::Out, {bytes.begin(), bytes.end()}};
    return fail(Errc::Corrupt, name_ + ": " + cursors_.place() + ", byte " +
                                   std::to_string(written_ + 1) + ": found '" + to_line(found) +
                                   "', expected '" + to_line(expected) + "'");
  }

  ReplayCursors<ByteRecord> cursors_;
  const std::string name_;
  Clock& clock_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t read_ = 0;     // bytes of next_in()
  std::size_t written_ = 0;  // bytes of next_out()
  bool closed_ = false;
};

}  // namespace

std::unique_ptr<ByteStream> make_replay_stream(std::vector<ByteRecord> records, std::string name,
                                               ReplayMode mode, Clock& clock) {
  std::erase_if(records, [](const ByteRecord& record) { return record.bytes.empty(); });
  return std::make_unique<ReplayStream>(std::move(records), std::move(name), mode, clock);
}

}  // namespace eyebridge::bridges
