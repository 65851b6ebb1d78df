#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/faults.hpp"

namespace eyebridge::bridges {

class FaultEngine;

/// A stream that damages what passes through another one. For tests and demonstrations.
///
/// A late chunk going out holds its writer up. A chunk going out that is merged waits for the next
/// write, but not beyond the next read: what waits for an answer has been sent.
/// With Unplug in its plan it is for one thread alone.
class FaultyStream final : public ByteStream {
 public:
  /// `clock`, the one of `inner`, must outlive this.
  FaultyStream(std::unique_ptr<ByteStream> inner, const FaultPlan& plan, Clock& clock);
  ~FaultyStream() override;
  FaultyStream(const FaultyStream&) = delete;
  FaultyStream& operator=(const FaultyStream&) = delete;

  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override;
  Result<void> write_all(std::span<const std::uint8_t> bytes, Time deadline) override;
  void close() override;
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }

  /// Any thread.
  [[nodiscard]] FaultCounts counts() const;

 private:
  struct Chunk {
    std::vector<std::uint8_t> bytes;
    Time due{};
  };

  Result<void> fetch(Time deadline);
  Result<void> flush(Time deadline);  // under writing_
  [[nodiscard]] tl::unexpected<Error> unplugged() const;

  std::unique_ptr<ByteStream> inner_;
  Clock& clock_;
  std::unique_ptr<FaultEngine> incoming_;
  std::unique_ptr<FaultEngine> outgoing_;
  std::deque<Chunk> arrived_;  // only the reader's
  std::mutex writing_;         // a reader flushes what a writer left
  std::vector<std::uint8_t> held_back_;
};

}  // namespace eyebridge::bridges
