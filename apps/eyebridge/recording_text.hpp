#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "eyebridge/camera/recording/frame_table.hpp"
#include "replay/ebrec.hpp"

namespace eyebridge::apps {

/// What was recorded of a robot and of its camera, in a few lines, and a table: how often each call
/// was made, when first and last, and how often it failed. `name` is what the recording is called.
std::string recording_summary(const hal::Recording& recording,
                              std::span<const camera::RecordedFrame> frames,
                              const std::string& name);

/// The first `most` exchanges, a line each: time, call, request, reply or error.
std::string recording_calls(const hal::Recording& recording, std::size_t most);

}  // namespace eyebridge::apps
