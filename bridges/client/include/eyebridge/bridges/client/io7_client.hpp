#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "eyebridge/base/log.hpp"
#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/client/io7_settings.hpp"
#include "eyebridge/bridges/io7/profile.hpp"
#include "eyebridge/bridges/io7/reply_parser.hpp"
#include "eyebridge/bridges/io7/request.hpp"

namespace eyebridge::bridges {

class Io7Session;
class LineGuard;

/// Opens the line to a board; also again, after it was lost.
using StreamOpener = std::function<Result<std::unique_ptr<ByteStream>>()>;

/// An IO7 board: probed, asked one request at a time, found again after it was lost.
///
/// Never sends a letter that the board does not list, and never `E`. Any thread, but connect() and
/// look_after() are for one of them. Whatever a board does, an exchange ends: after a reply_timeout
/// when it is silent, plus a resynchronisation. Its end sends nothing: confirm_stop() before.
class Io7Client {
 public:
  /// `clock` is the one of the streams; it and `log` must outlive this.
  Io7Client(StreamOpener open, Clock& clock, LogSink& log, const Io7Settings& settings = {});
  ~Io7Client();
  Io7Client(const Io7Client&) = delete;
  Io7Client& operator=(const Io7Client&) = delete;

  /// Opens the line, probes the board until it answers, and sets all motors to 0. Fails as opening
  /// does, or as io7::Probe does when there is no such board behind the line.
  Result<void> connect();

  /// Asks and gives the reply, repeating once what failed. On a line that has spoiled bytes twice
  /// within five seconds, and until it has not for as long, a reading counts when two agree (of six
  /// at most, else Corrupt), commands are sent twice, and what motors, servos and outputs were told
  /// last is told again: motors every 10 ms. Fails with Unsupported (the board does
  /// not list the letter), OutOfRange, Timeout, Corrupt, or Disconnected: from the loss of the line
  /// until look_after() has found the board again. Allocates only when it fails. `asked`, when not
  /// null, becomes the time at which the question that was answered went out.
  Result<io7::Reply> exchange(const io7::Request& request, Time* asked = nullptr);

  /// Stops all motors and waits until the board has heard it, answering what is asked after it;
  /// then the guard has nothing to do at the end. Fails with why it is not known that they stand.
  Result<void> confirm_stop();

  /// To be called every now and then: asks a board that has been idle for its version; tries to
  /// open a lost line, waiting longer each time, and makes the board behind it ready as connect()
  /// does. Others are not held up while it does. True when a board was found again.
  bool look_after();

  /// Grows each time that a board was made ready: whatever it was told before is gone.
  [[nodiscard]] std::uint32_t generation() const;
  /// Whether the board lists `letter`; false while there is none.
  [[nodiscard]] bool has(char letter) const;
  /// What the board turned out to be; null before connect(). After a loss that of the last one.
  [[nodiscard]] std::optional<io7::ProbeReport> report() const;
  [[nodiscard]] Io7Statistics statistics() const;

 private:
  Result<void> find_board(Time patience);
  Result<void> guard();           // under mutex_, with a session
  void note_guard();              // under mutex_
  void lose(const Error& error);  // under mutex_
  Result<void> keep_alive();      // likewise, with a session
  void note_found(const io7::ProbeReport& report, std::string_view name) const;

  const StreamOpener open_;
  Clock& clock_;
  LogSink& log_;
  const Io7Settings settings_;

  mutable std::mutex mutex_;  // of everything below
  std::unique_ptr<LineGuard> guard_;
  std::unique_ptr<Io7Session> session_;
  std::optional<io7::ProbeReport> report_;
  Error loss_;
  Time retry_at_{0};
  Time backoff_;
  std::uint32_t generation_ = 0;
  Io7Statistics statistics_;
};

}  // namespace eyebridge::bridges
