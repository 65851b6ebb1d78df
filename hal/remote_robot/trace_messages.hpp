#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/hal/trace.hpp"
#include "remote_robot/bytes.hpp"
#include "remote_robot/message.hpp"

namespace eyebridge::hal {

/// Keeps a trace as messages, each of a megabyte at most. One thread at a time.
class TraceMessages final : public TraceSink {
 public:
  void point(const TracePoint& point) noexcept override;
  void contact(const TraceContact& contact) noexcept override;
  /// Those since the last time.
  std::vector<Message> take();

 private:
  void begin(char what);

  ByteWriter writer_;
  std::vector<Message> full_;
};

/// Tells `sink` what the message holds; nothing of the rest, and false, from where on it is wrong.
bool tell_trace(std::span<const std::uint8_t> message, TraceSink& sink);

}  // namespace eyebridge::hal
