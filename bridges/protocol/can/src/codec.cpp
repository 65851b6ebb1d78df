#include "eyebridge/bridges/can/codec.hpp"

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <string>

namespace eyebridge::bridges::can {
namespace {

std::string id_text(std::uint32_t id) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%03X", static_cast<unsigned>(id));
  return text;
}

std::string range_text(const Signal& signal) {
  return std::to_string(signal.first) + " to " + std::to_string(signal.last) +
         (signal.may_be_absent ? " or 65535 for none" : "");
}

tl::unexpected<Error> bad_value(Errc code, const MessageSpec& spec, const Signal& signal,
                                std::int64_t value) {
  return fail(code, std::string(spec.name) + "." + std::string(signal.name) + " is " +
                        std::to_string(value) + "; expected " + range_text(signal));
}

tl::unexpected<Error> inconsistent(Errc code, const MessageSpec& spec) {
  return fail(code, std::string(spec.name) +
                        ": its values do not fit together; expected: " + std::string(spec.comment));
}

bool is_node_of(const MessageSpec& spec, int node) {
  return node >= spec.first_node && node <= spec.last_node;
}

void put_bits(CanFrame& frame, const Signal& signal, std::uint64_t bits) {
  for (unsigned i = 0; i < signal.length; ++i) {
    const unsigned at = signal.start + i;
    frame.data[at / 8] =
        static_cast<std::uint8_t>(frame.data[at / 8] | ((bits >> i) & 1U) << at % 8);
  }
}

std::int64_t take_bits(const CanFrame& frame, const Signal& signal) {
  std::uint64_t bits = 0;
  for (unsigned i = 0; i < signal.length; ++i) {
    const unsigned at = signal.start + i;
    bits |= static_cast<std::uint64_t>((frame.data[at / 8] >> at % 8) & 1U) << i;
  }
  if (signal.is_signed && (bits >> (signal.length - 1U)) != 0)
    bits |= ~std::uint64_t{0} << signal.length;
  return static_cast<std::int64_t>(bits);
}

}  // namespace

Result<CanFrame> encode_raw(const MessageSpec& spec, int node,
                            std::span<const std::int64_t> values) {
  if (!is_node_of(spec, node)) {
    return fail(Errc::OutOfRange, std::string(spec.name) + ": node is " + std::to_string(node) +
                                      "; expected " + std::to_string(spec.first_node) + " to " +
                                      std::to_string(spec.last_node));
  }
  CanFrame frame{.id = spec.id(node), .length = spec.length, .fd = spec.fd};
  std::size_t at = 0;
  for (const Signal& signal : spec.signals) {
    if (signal.bank >= 0 && signal.bank != values[0]) continue;
    assert(at < values.size());
    const std::int64_t value = values[at++];
    if (!signal.accepts(value)) return bad_value(Errc::OutOfRange, spec, signal, value);
    put_bits(frame, signal, static_cast<std::uint64_t>(value));
  }
  assert(at == values.size());
  if (spec.consistent != nullptr && !spec.consistent(values)) {
    return inconsistent(Errc::OutOfRange, spec);
  }
  return frame;
}

Result<RawValues> decode_raw(const MessageSpec& spec, const CanFrame& frame) {
  if (!is_protocol_format(frame) || function_of(frame.id) != spec.function || frame.fd != spec.fd) {
    return fail(Errc::Unsupported,
                "frame " + id_text(frame.id) + " is no " + std::string(spec.name));
  }
  if (!is_node_of(spec, node_of(frame.id))) {
    return fail(Errc::Corrupt,
                std::string(spec.name) + ": impossible node " + std::to_string(node_of(frame.id)));
  }
  if (frame.length < spec.length ||
      frame.length > (frame.fd ? CanFrame::kMaxFd : CanFrame::kMaxClassic)) {
    return fail(Errc::Corrupt, std::string(spec.name) + " " + id_text(frame.id) + " has " +
                                   std::to_string(frame.length) + " bytes; expected " +
                                   std::to_string(spec.length));
  }
  RawValues raw;
  for (const Signal& signal : spec.signals) {
    if (signal.bank >= 0 && signal.bank != raw.values[0]) continue;
    const std::int64_t value = take_bits(frame, signal);
    if (!signal.accepts(value)) return bad_value(Errc::Corrupt, spec, signal, value);
    raw.push(value);
  }
  if (spec.consistent != nullptr && !spec.consistent(raw.view())) {
    return inconsistent(Errc::Corrupt, spec);
  }
  return raw;
}

}  // namespace eyebridge::bridges::can
