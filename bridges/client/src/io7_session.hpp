#pragma once

#include <array>
#include <memory>

#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/client/io7_settings.hpp"
#include "eyebridge/bridges/io7/probe.hpp"
#include "eyebridge/bridges/io7/reply_parser.hpp"
#include "line_quality.hpp"
#include "standing_orders.hpp"

namespace eyebridge::bridges {

class LineGuard;

/// One line to one board that was probed: a request, its reply, and finding back when they no
/// longer fit. For one thread at a time. Disconnected is final.
///
/// While the line is noisy (LineQuality) a reading counts when two agree, commands that nothing
/// answers are sent twice, and what motors, servos and outputs were told last is repeated. A clean
/// line carries nothing of that.
class Io7Session {
 public:
  /// What is referred to must outlive this.
  Io7Session(std::unique_ptr<ByteStream> stream, io7::ProbeReport report, Clock& clock,
             const Io7Settings& settings, Io7Statistics& statistics);

  /// From now on `guard` hears of wheels that turn; it must outlive this.
  void guard_with(LineGuard* guard) { guard_ = guard; }
  /// False once the guard turned out to be gone.
  [[nodiscard]] bool is_guarded() const { return guard_ != nullptr; }

  /// Fails with Unsupported or OutOfRange as io7::encode() does, before anything is sent; with
  /// Timeout or Corrupt when also the second attempt failed; Disconnected when the line is gone or
  /// the board does not answer as itself any more. Allocates only when it fails.
  Result<io7::Reply> exchange(const io7::Request& request);

  /// To be called every 10 ms: repeats what the board was told, while the line is noisy and the
  /// board answers. Fails with Timeout or Disconnected.
  Result<void> repeat_orders();

  /// Sets every motor to 0.
  Result<void> stop_motors();
  /// The same, and waits until the board has answered what was asked after it.
  Result<void> confirm_stop();

  [[nodiscard]] const io7::ProbeReport& report() const { return report_; }
  [[nodiscard]] ByteStream& stream() { return *stream_; }
  /// The line, for another session: this one is over.
  std::unique_ptr<ByteStream> release_stream() { return std::move(stream_); }
  [[nodiscard]] Time last_heard() const { return last_heard_; }
  /// When the last question went out.
  [[nodiscard]] Time last_asked() const { return last_asked_; }

 private:
  Result<io7::Reply> exchange_once(const io7::Request& request, const io7::RequestBytes& bytes);
  Result<io7::Reply> ask(const io7::Request& request, const io7::RequestBytes& bytes,
                         Time patience);
  /// Before `request` is sent: whether wheels turn from then on.
  void note_turning(const io7::Request& request);
  /// The guard hears that the program lives.
  void tell_guard(Time now);
  Result<void> resync();
  Result<void> expect_silence();
  /// Bytes that came until the line was quiet, for `quiet` or, if that is longer, until a board
  /// gives up a request that it has in part.
  Result<std::size_t> drain_until_quiet(Time quiet = Time{0});
  [[nodiscard]] bool speaks_lines() const;
  void note_latency(Time latency);
  [[nodiscard]] Time reply_patience() const;
  /// The longest wait for a reply: on a line that is late at times, as long as that takes.
  [[nodiscard]] Time longest_patience() const;

  // On a noisy line, in noisy_line.cpp.
  /// Whether the encoders do not change for a tenth of a second.
  bool wheels_stand();
  [[nodiscard]] bool noisy() const { return quality_.noisy(clock_.now()); }
  /// A reading that another one agrees with; a command that was sent twice.
  Result<io7::Reply> confirmed(const io7::Request& request, const io7::RequestBytes& bytes,
                               const io7::Reply& first);
  Result<io7::Reply> agreed(const io7::Request& request, const io7::RequestBytes& bytes,
                            const io7::Reply& first);
  /// Whether orders are to be repeated.
  [[nodiscard]] bool orders_stand() const;
  /// Sends what is due, where nothing answers it.
  Result<void> write_orders();
  /// Makes replies raw again, where they were.
  void quieten();
  /// Whether nothing at all comes back for a command.
  [[nodiscard]] bool is_unanswered() const;
  /// Whether orders may be sent while a reply is waited for.
  [[nodiscard]] bool orders_interrupt() const;

  std::unique_ptr<ByteStream> stream_;
  io7::ProbeReport report_;
  Clock& clock_;
  const Io7Settings settings_;  ///< For this board.
  Io7Statistics& statistics_;
  LineQuality quality_;
  StandingOrders orders_;
  LineGuard* guard_ = nullptr;  ///< Null: nobody guards this line, or the guard is gone.
  bool turning_ = false;        ///< Wheels may turn.
  io7::ReplyParser parser_;
  std::array<std::uint8_t, 512> buffer_{};
  Time smoothed_latency_{0};  ///< 0: none known.
  Time last_heard_{0};
  Time last_asked_{0};
  Time last_drained_{0};  ///< When the last byte came that nobody asked for.
};

}  // namespace eyebridge::bridges
