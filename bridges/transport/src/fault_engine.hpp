#pragma once

#include <mutex>
#include <optional>

#include "eyebridge/base/random.hpp"
#include "eyebridge/bridges/faults.hpp"

namespace eyebridge::bridges {

/// What happens to one byte or frame.
struct Fate {
  bool unplug = false;
  bool drop = false;
  bool split = false;
  bool repeat = false;
  bool delay = false;            ///< By script; chance delays whole chunks.
  std::optional<unsigned> flip;  ///< Which bit.
};

/// Decides the faults of one direction. Each kind draws from its own random stream, once for each
/// byte or frame: the same seed hits the same ones, however they are grouped into chunks.
class FaultEngine {
 public:
  /// `direction` tells the streams of one plan apart.
  FaultEngine(const LineFaults& faults, std::uint64_t seed, std::uint64_t direction);

  /// What happens to the next byte or frame, which has `bits` bits.
  Fate next(unsigned bits);
  /// Whether the next chunk is late, beside what the script says.
  bool next_chunk_is_late() { return delay_.chance(faults_.delay); }
  /// Whether the next chunk comes together with the one behind it.
  bool next_chunk_is_merged() { return merge_.chance(faults_.merge); }
  [[nodiscard]] Time delay_by() const { return faults_.delay_by; }

  void count(std::uint64_t FaultCounts::*kind);
  [[nodiscard]] FaultCounts counts() const;

 private:
  LineFaults faults_;
  Random drop_, flip_, repeat_, split_, delay_, merge_;
  std::uint64_t position_ = 0;
  std::size_t next_script_ = 0;
  mutable std::mutex mutex_;
  FaultCounts counts_;
};

/// Both directions together.
FaultCounts operator+(const FaultCounts& a, const FaultCounts& b);

}  // namespace eyebridge::bridges
