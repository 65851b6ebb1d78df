#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/can_bus.hpp"

namespace eyebridge::bridges {

// What passes a line, as text: to look at, to compare, to replay.
//
// Bytes, one chunk a line: microseconds, '<' for in or '>' for out, hex digits:
//   1503210 > 6D20312035300D
// CAN frames, as `candump -L` has them: (seconds) interface id#data, and R for in or T for out:
//   (1.503210) can0 181#C01DFED21E00D8DC R
//   (1.503310) can0 00000123##1AABB T          CAN FD: ## and a digit of flags; 8 digits: 29-bit id
//   (1.503410) can0 123#R4                     remote frame; no direction: not known
// Empty lines and lines that begin with '#' are comments in both.

/// Which way something went, seen from the program.
enum class Direction { Unknown, In, Out };

/// One line of a byte trace.
struct ByteRecord {
  Time time{};  ///< Whole microseconds, not negative.
  Direction direction = Direction::In;
  std::vector<std::uint8_t> bytes;

  friend bool operator==(const ByteRecord&, const ByteRecord&) = default;
};

/// One line of a CAN trace.
struct CanRecord {
  Time time{};            ///< Whole microseconds, not negative.
  std::string interface;  ///< Printable, without blanks.
  CanFrame frame;
  Direction direction = Direction::Unknown;

  friend bool operator==(const CanRecord&, const CanRecord&) = default;
};

/// The line of a record, without a line end. Times are cut to microseconds.
std::string to_line(const ByteRecord& record);
std::string to_line(const CanRecord& record);

/// All records of a trace. Throws ConfigError, naming `file`, line and column, at the first line
/// that is none.
std::vector<ByteRecord> read_byte_trace(std::string_view text, const std::string& file);
std::vector<CanRecord> read_can_trace(std::string_view text, const std::string& file);

/// Where lines of a trace go, without line end; never called twice at once.
using TraceSink = std::function<void(std::string_view line)>;

/// A stream that tells `sink` each chunk that is read and, before it goes out, each that is
/// written. `clock` must outlive it.
std::unique_ptr<ByteStream> make_traced(std::unique_ptr<ByteStream> inner, Clock& clock,
                                        TraceSink sink);

/// The same for the frames of a bus.
std::unique_ptr<CanBus> make_traced(std::unique_ptr<CanBus> inner, Clock& clock, TraceSink sink);

}  // namespace eyebridge::bridges
