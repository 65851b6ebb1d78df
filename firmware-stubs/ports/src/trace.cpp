#include "eyebridge/ports/trace.hpp"

#include <chrono>

#include <fmt/format.h>

namespace eyebridge::ports {
namespace {

std::int64_t microseconds(Time time) {
  return std::chrono::duration_cast<std::chrono::microseconds>(time).count();
}

std::string hex_of(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) fmt::format_to(std::back_inserter(text), "{:02X}", byte);
  return text;
}

std::string frame_text(const eb_can_frame& frame) {
  return fmt::format("{:0{}X}{}{}", frame.id, frame.extended ? 8 : 3,
                     frame.fd       ? "##0"
                     : frame.remote ? "#R"
                                    : "#",
                     hex_of({frame.data, frame.length}));
}

std::string frame_line(Time time, const std::string& name, const eb_can_frame& frame, char way) {
  const std::int64_t us = microseconds(time);
  return fmt::format("({}.{:06}) {} {} {}", us / 1'000'000, us % 1'000'000, name, frame_text(frame),
                     way);
}

}  // namespace

ByteLine traced(const ByteLine& line, const TraceSink& sink, const Now& now) {
  ByteLine out;
  out.receive = [line, sink, now](std::span<const std::uint8_t> bytes) {
    sink(fmt::format("{} < {}", microseconds(now()), hex_of(bytes)));
    line.receive(bytes);
  };
  out.transmit = [line, sink, now](std::span<std::uint8_t> room) {
    const std::size_t made = line.transmit(room);
    if (made > 0) sink(fmt::format("{} > {}", microseconds(now()), hex_of(room.first(made))));
    return made;
  };
  out.lost = [line, sink, now] {
    sink(fmt::format("# {}: the host is gone", microseconds(now())));
    line.lost();
  };
  return out;
}

FrameLine traced(const FrameLine& line, const std::string& name, const TraceSink& sink,
                 const Now& now) {
  FrameLine out;
  out.receive = [=](const eb_can_frame& frame) {
    sink(frame_line(now(), name, frame, 'R'));
    line.receive(frame);
  };
  out.transmit = [=](eb_can_frame& frame) {
    const bool made = line.transmit(frame);
    if (made) sink(frame_line(now(), name, frame, 'T'));
    return made;
  };
  out.lost = [=] {
    sink(fmt::format("# {}: the bus is gone", microseconds(now())));
    line.lost();
  };
  return out;
}

}  // namespace eyebridge::ports
