#pragma once

#include <map>
#include <mutex>
#include <string>

#include "eyebridge/base/log.hpp"
#include "replay/ebrec.hpp"

namespace eyebridge::hal {

/// Answers calls from a recording, one call after the other: what the program calls now must be
/// what it called then, with the same numbers. The clock moves along with the recording. The first
/// deviation is logged with its time and both calls; from there on every call fails with Corrupt.
class StrictReplay final : public CallInterceptor {
 public:
  /// `clock` and `log` are lent.
  StrictReplay(std::vector<Exchange> exchanges, Clock& clock, LogSink& log);
  Result<Values> exchange(const Call& call, const std::function<Result<Values>()>& device) override;
  /// Warns when the recording goes on where the program has ended.
  void finish() noexcept override;

 private:
  const std::vector<Exchange> exchanges_;
  Clock& clock_;
  LogSink& log_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  bool finished_ = false;
  std::string deviation_;  ///< "" until there is one.
};

/// Answers readings with what the recording holds for that moment (the last one before it, or its
/// first), whatever the program calls; takes commands without doing anything. A reading that was
/// never made fails with Unsupported.
class LenientReplay final : public CallInterceptor {
 public:
  LenientReplay(const std::vector<Exchange>& exchanges, Clock& clock);
  Result<Values> exchange(const Call& call, const std::function<Result<Values>()>& device) override;

 private:
  /// Replies of one reading, by time.
  using Replies = std::map<Time, Result<Values>>;
  std::map<std::string, Replies> readings_;  ///< By "psd 1 read".
  Clock& clock_;
};

}  // namespace eyebridge::hal
