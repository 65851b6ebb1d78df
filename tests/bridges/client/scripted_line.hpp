#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "../transport/fake_clock.hpp"
#include "eyebridge/bridges/byte_stream.hpp"

namespace eyebridge::bridges::testing {

/// The other side of a line, by script, on virtual time: what is written is answered at once, with
/// bytes that arrive when the script says.
struct ScriptedLine {
  explicit ScriptedLine(FakeClock& its_clock) : clock(its_clock) {}

  /// `bytes` arrive `after` from now, behind what is on its way already.
  void arrive(std::string_view bytes, Time after = Time{0}) {
    for (const char byte : bytes) incoming.push_back({clock.now() + after, byte});
  }

  struct Byte {
    Time due;
    char value;
  };

  FakeClock& clock;
  std::function<void(ScriptedLine&, const std::string& sent)> on_write;
  std::deque<Byte> incoming;
  std::string sent;   ///< All that was ever written.
  bool gone = false;  ///< Unplugged: what is on its way arrives, then Disconnected.
};

/// This side of it. Never waits longer than the deadline, on virtual time.
class ScriptedStream final : public ByteStream {
 public:
  explicit ScriptedStream(std::shared_ptr<ScriptedLine> line) : line_(std::move(line)) {}

  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    ScriptedLine& line = *line_;
    if (line.incoming.empty() && line.gone) return fail(Errc::Disconnected, "script: unplugged");
    if (line.incoming.empty() || line.incoming.front().due > std::max(deadline, line.clock.now())) {
      line.clock.wait_until(deadline);
      return fail(Errc::Timeout, "script: nothing came in time");
    }
    line.clock.wait_until(line.incoming.front().due);
    std::size_t count = 0;
    for (; count < buffer.size() && !line.incoming.empty() &&
           line.incoming.front().due <= line.clock.now();
         ++count) {
      buffer[count] = static_cast<std::uint8_t>(line.incoming.front().value);
      line.incoming.pop_front();
    }
    return count;
  }
  Result<void> write_all(std::span<const std::uint8_t> bytes, Time) override {
    if (line_->gone) return fail(Errc::Disconnected, "script: unplugged");
    const std::string text(bytes.begin(), bytes.end());
    line_->sent += text;
    if (line_->on_write) line_->on_write(*line_, text);
    return {};
  }
  void close() override { line_->gone = true; }
  [[nodiscard]] std::string_view name() const override { return "script"; }

 private:
  std::shared_ptr<ScriptedLine> line_;
};

}  // namespace eyebridge::bridges::testing
