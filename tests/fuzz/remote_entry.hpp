#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "remote_robot/message.hpp"
#include "remote_robot/remote_view.hpp"
#include "remote_robot/trace_messages.hpp"

// As entry.hpp, for what the two ends of a line to a robot of another process say.
namespace eyebridge::fuzz {

/// What is accepted has the bytes that it was read from.
inline void remote_message(std::string_view text) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  const auto check = [&](const hal::Message& again) {
    if (!std::equal(again.begin(), again.end(), bytes.begin(), bytes.end())) std::abort();
  };
  if (const auto request = hal::decode_request(bytes)) check(encode(*request));
  if (const auto reply = hal::decode_reply(bytes)) {
    check(encode(*reply));
    world::Scene scene;
    if (reply->values && hal::unpack_scene(*reply->values, scene)) {
      if (reply->values->size() != hal::pack_scene(scene).size()) std::abort();
    }
  }
  if (const auto welcome = hal::decode_welcome(bytes)) check(encode(*welcome));
  hal::TraceMessages trace;
  if (!hal::tell_trace(bytes, trace)) return;
  hal::Message all;
  for (const hal::Message& part : trace.take()) {
    // The kind stands once.
    all.insert(all.end(), part.begin() + (all.empty() ? 0 : 1), part.end());
  }
  if (!all.empty()) check(all);
}

}  // namespace eyebridge::fuzz
