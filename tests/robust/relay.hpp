#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/bridges/faulty_stream.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"

namespace eyebridge::testing {

/// Stands between a program and the TCP port of its board, and damages what passes, but for the
/// beginning, in which the board is found. For one program.
class Relay {
 public:
  /// `board` is HOST:PORT. Throws std::runtime_error.
  Relay(const std::string& board, const bridges::FaultPlan& plan);
  ~Relay();
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  /// What the program's `--hal` must be.
  [[nodiscard]] std::string hal() const;
  [[nodiscard]] bridges::FaultCounts counts() const;

 private:
  void serve(const std::stop_token& stop);

  bridges::MonotonicClock clock_;
  UniqueFd listener_;
  bridges::FaultPlan plan_;
  std::unique_ptr<bridges::ByteStream> board_;
  bridges::ByteStream* sound_ = nullptr;  // what damaged_ damages
  std::unique_ptr<bridges::FaultyStream> damaged_;
  std::atomic<bool> connected_ = false;
  std::size_t carried_ = 0;  // bytes
  std::jthread thread_;
};

}  // namespace eyebridge::testing
