#include "eyebridge/bridges/client/dbc_plan.hpp"

#include <algorithm>

#include "eyebridge/bridges/dbc/signal.hpp"

namespace eyebridge::bridges {
namespace {

/// All of `bytes` but the one at `skipped`, by a sum that takes them one after the other.
std::uint8_t checksum_of(const DbcChecksum& checksum, std::span<const std::uint8_t> bytes,
                         std::size_t own, std::uint64_t counter) {
  if (checksum.kind == DbcChecksum::Kind::AutosarProfile1) {
    return dbc::autosar_profile1(checksum.data_id, checksum.mode,
                                 static_cast<std::uint8_t>(counter), bytes, own);
  }
  std::vector<std::uint8_t> others(bytes.begin(), bytes.end());
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(own));
  return checksum.kind == DbcChecksum::Kind::Xor ? dbc::xor_of(others) : dbc::sae_j1850(others);
}

}  // namespace

CanFrame dbc_frame(const DbcCommand& command, const std::vector<std::uint8_t>& bytes,
                   std::uint64_t counter) {
  const dbc::Message& message = command.message;
  CanFrame frame;
  frame.id = message.id;
  frame.extended = message.extended;
  frame.fd = message.fd;
  frame.length = static_cast<std::uint8_t>(message.length);
  std::ranges::copy(bytes, frame.data.begin());
  const std::span<std::uint8_t> data(frame.data.data(), frame.length);
  if (command.counter) dbc::put_bits(message.signals[command.counter->signal], counter, data);
  if (command.checksum) {
    const dbc::Signal& signal = message.signals[command.checksum->signal];
    const auto own = static_cast<std::size_t>(signal.start / 8);
    dbc::put_bits(signal, checksum_of(*command.checksum, data, own, counter), data);
  }
  return frame;
}

std::uint64_t next_counter(const DbcCommand& command, std::uint64_t counter) {
  return !command.counter || counter >= command.counter->last ? 0 : counter + 1;
}

bool is_of(const dbc::Message& message, const CanFrame& frame) {
  return frame.id == message.id && frame.extended == message.extended && !frame.remote;
}

}  // namespace eyebridge::bridges
