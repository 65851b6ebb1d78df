#pragma once

#include <algorithm>
#include <memory>

#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/can_bus.hpp"
#include "eyebridge/ports/port.hpp"

namespace eyebridge::firmware {

/// A board on its end of one of the bridge's streams; `stream` must outlive the port.
inline std::unique_ptr<ports::Port> port_on(ports::ByteLine line, bridges::ByteStream& stream) {
  return ports::make_memory_port(
      std::move(line),
      {[&stream](std::span<std::uint8_t> buffer) -> std::ptrdiff_t {
         const auto got = stream.read_some(buffer, Time{});
         if (got) return static_cast<std::ptrdiff_t>(*got);
         return got.error().code == Errc::Timeout ? 0 : -1;
       },
       // A host that is gone is noticed by the next read.
       [&stream](std::span<const std::uint8_t> bytes) { (void)stream.write_all(bytes, Time{}); }});
}

/// A board as a node on one of the bridge's buses; `bus` must outlive the port.
inline std::unique_ptr<ports::Port> port_on(ports::FrameLine line, bridges::CanBus& bus) {
  return ports::make_memory_port(std::move(line),
                                 {[&bus](eb_can_frame& frame) {
                                    const auto got = bus.receive(Time{});
                                    if (!got) return got.error().code == Errc::Timeout ? 0 : -1;
                                    frame = {};
                                    frame.id = got->id;
                                    frame.extended = got->extended;
                                    frame.fd = got->fd;
                                    frame.remote = got->remote;
                                    frame.length = got->remote ? std::uint8_t{0} : got->length;
                                    std::ranges::copy(got->bytes(), frame.data);
                                    return 1;
                                  },
                                  [&bus](const eb_can_frame& frame) {
                                    bridges::CanFrame sent{.id = frame.id, .length = frame.length};
                                    sent.fd = frame.fd;
                                    sent.extended = frame.extended;
                                    std::copy_n(frame.data, frame.length, sent.data.begin());
                                    (void)bus.send(sent, Time{});
                                  }});
}

}  // namespace eyebridge::firmware
