#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

#include "../bridges/transport/fake_clock.hpp"
#include "board_fixture.hpp"
#include "eyebridge/bridges/byte_stream.hpp"

namespace eyebridge::firmware {

/// A line to a board that lives in the same virtual time: it goes on while the host waits, and its
/// answers take 1 ms. Until `asleep_until` nothing is heard, done or said there, as when the
/// computer that runs the firmware is busy.
class BoardStream final : public bridges::ByteStream {
 public:
  BoardStream(BoardUnderTest& board, bridges::testing::FakeClock& clock, const Time& asleep_until)
      : board_(board), clock_(clock), asleep_until_(asleep_until), board_time_(clock.now()) {}

  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    catch_up();
    const Time end = std::max(deadline, clock_.now());
    while (coming_.empty() || coming_.front().due > clock_.now()) {
      if (clock_.now() >= end) return fail(Errc::Timeout, "board: nothing came in time");
      clock_.wait_until(std::min(end, clock_.now() + kStep));
      catch_up();
    }
    std::size_t count = 0;
    while (count < buffer.size() && !coming_.empty() && coming_.front().due <= clock_.now()) {
      buffer[count++] = static_cast<std::uint8_t>(coming_.front().value);
      coming_.pop_front();
    }
    return count;
  }
  Result<void> write_all(std::span<const std::uint8_t> bytes, Time) override {
    waiting_.append(bytes.begin(), bytes.end());
    catch_up();
    return {};
  }
  void close() override {}
  [[nodiscard]] std::string_view name() const override { return "board"; }

 private:
  struct Byte {
    Time due;
    char value;
  };

  /// Lets the board live until now, and hear what it was sent.
  void catch_up() {
    if (clock_.now() < asleep_until_) return;
    const auto us =
        std::chrono::duration_cast<std::chrono::microseconds>(clock_.now() - board_time_);
    board_.wait_us(static_cast<std::uint32_t>(us.count()));
    board_time_ += us;
    const Time due = clock_.now() + kStep;
    for (const char byte : board_.ask(std::exchange(waiting_, {}))) coming_.push_back({due, byte});
  }

  static constexpr Time kStep = std::chrono::milliseconds(1);

  BoardUnderTest& board_;
  bridges::testing::FakeClock& clock_;
  const Time& asleep_until_;
  Time board_time_;
  std::string waiting_;  ///< On its way to the board.
  std::deque<Byte> coming_;
};

}  // namespace eyebridge::firmware
