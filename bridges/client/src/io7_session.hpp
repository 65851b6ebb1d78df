#pragma once

#include <array>
#include <memory>

#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/client/io7_settings.hpp"
#include "eyebridge/bridges/io7/probe.hpp"
#include "eyebridge/bridges/io7/reply_parser.hpp"

namespace eyebridge::bridges {

/// One line to one board that was probed: a request, its reply, and finding back when they no
/// longer fit. For one thread at a time. Disconnected is final.
class Io7Session {
 public:
  /// What is referred to must outlive this.
  Io7Session(std::unique_ptr<ByteStream> stream, io7::ProbeReport report, Clock& clock,
             const Io7Settings& settings, Io7Statistics& statistics);

  /// Fails with Unsupported or OutOfRange as io7::encode() does, before anything is sent; with
  /// Timeout or Corrupt when also the second attempt failed; Disconnected when the line is gone or
  /// the board does not answer as itself any more. Allocates only when it fails.
  Result<io7::Reply> exchange(const io7::Request& request);

  /// Sets every motor to 0.
  Result<void> stop_motors();

  [[nodiscard]] const io7::ProbeReport& report() const { return report_; }
  [[nodiscard]] ByteStream& stream() { return *stream_; }
  /// The line, for another session: this one is over.
  std::unique_ptr<ByteStream> release_stream() { return std::move(stream_); }
  [[nodiscard]] Time last_heard() const { return last_heard_; }

 private:
  Result<io7::Reply> ask(const io7::Request& request, const io7::RequestBytes& bytes,
                         Time patience);
  Result<void> resync();
  Result<void> expect_silence();
  /// Bytes that came until the line was quiet, for so long that a board gives up a request that it
  /// has in part.
  Result<std::size_t> drain_until_quiet();
  [[nodiscard]] bool speaks_lines() const;
  void note_latency(Time latency);
  [[nodiscard]] Time reply_patience() const;

  std::unique_ptr<ByteStream> stream_;
  io7::ProbeReport report_;
  Clock& clock_;
  const Io7Settings& settings_;
  Io7Statistics& statistics_;
  io7::ReplyParser parser_;
  std::array<std::uint8_t, 512> buffer_{};
  Time smoothed_latency_{0};  ///< 0: none known.
  Time last_heard_{0};
};

}  // namespace eyebridge::bridges
