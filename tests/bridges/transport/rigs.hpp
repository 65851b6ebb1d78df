#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/can_bus.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"

namespace eyebridge::bridges::testing {

/// For what must happen: never reached unless something is broken.
constexpr Time kSoon = std::chrono::seconds(60);
/// A deadline that has passed on every clock: for what must not have happened.
constexpr Time kPast{0};

/// What went wrong, for messages of failing tests.
template <class T>
std::string what(const Result<T>& result) {
  return result ? "no error" : result.error().what;
}

using Bytes = std::vector<std::uint8_t>;

/// `count` bytes that look random, the same for the same `seed`.
Bytes noise(std::size_t count, std::uint64_t seed);

/// Reads exactly `count` bytes, or as many as come before an error.
Bytes read_exactly(ByteStream& stream, std::size_t count, Time deadline);

/// A raw pseudo-terminal: the descriptor of its master, and the path of its other end.
std::pair<UniqueFd, std::string> open_pty();
/// A connected pair of sockets of `type`: SOCK_STREAM, SOCK_SEQPACKET.
std::pair<UniqueFd, UniqueFd> socket_pair(int type);

/// Both ends of a line.
struct StreamRig {
  std::unique_ptr<MonotonicClock> clock;
  std::unique_ptr<ByteStream> near;
  std::unique_ptr<ByteStream> far;
};
struct StreamCase {
  const char* name;
  StreamRig (*make)();
};
void PrintTo(const StreamCase& row, std::ostream* out);
/// All kinds of streams that there are.
std::vector<StreamCase> stream_cases();

/// Two nodes on one bus, and hands on the cable.
struct BusRig {
  std::unique_ptr<MonotonicClock> clock;
  std::unique_ptr<CanBus> near;
  std::unique_ptr<CanBus> far;
  std::function<void(const CanFrame&)> report;  ///< `near`'s controller reports an error frame.
  std::function<void(BusRig&)> unplug;          ///< The bus goes away from `near`.
  std::function<void(BusRig&)> replug;          ///< It comes back, with a new `far`.
  bool drops = false;  ///< Loses what a receiver does not fetch, instead of making senders wait.
};
struct BusCase {
  std::string name;
  BusRig (*make)(const std::string& name);
};
void PrintTo(const BusCase& row, std::ostream* out);
/// All kinds of buses that there are, and the interfaces that EYEBRIDGE_TEST_CAN names ("vcan0" or
/// "vcan0,vcan1"): up, with MTU 72, without other traffic, and we may take them down and up.
std::vector<BusCase> bus_cases();

}  // namespace eyebridge::bridges::testing
