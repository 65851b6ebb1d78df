#include "v4l2/v4l2_source.hpp"

#include <algorithm>
#include <cmath>

#include "eyebridge/base/config_error.hpp"
#include "sources/frame_schedule.hpp"
#include "sources/sources.hpp"
#include "sources/stderr_log.hpp"

namespace eyebridge::camera {
namespace {

using std::chrono::milliseconds;

// How long to wait at once: the robot's clock may run at any rate, and be paused.
constexpr Time kSlice = milliseconds(20);
constexpr Time kBetweenLooks = milliseconds(500);
constexpr Time kBetweenRestarts = milliseconds(100);
constexpr Time kLeastPatience = milliseconds(1000);
constexpr double kPatienceFrames = 10.0;

/// How long a camera at `fps` may send nothing.
Time patience(double fps) {
  return fps > 0.0 ? std::max(kLeastPatience, from_seconds(kPatienceFrames / fps)) : kLeastPatience;
}

std::string seconds_text(Time span) { return rate_text(to_seconds(span)) + " s"; }

}  // namespace

V4l2Source::V4l2Source(VideoCalls& calls, CameraUrl wanted, const SourceContext& context,
                       std::filesystem::path root)
    : calls_(calls),
      clock_(*context.clock),
      log_(log_or_stderr(context.log)),
      opener_(calls, std::move(wanted), std::move(root), log_),
      stream_(opener_.open()),
      mode_(stream_->mode()),
      size_(mode_.size),
      last_sign_(calls.monotonic()) {
  say(Severity::Info,
      to_text(mode_.size) + " " + format_name(mode_.fourcc) +
          (mode_.fps > 0.0 ? ", " + rate_text(mode_.fps) + " frames a second" : ""));
}

V4l2Source::~V4l2Source() {
  say(Severity::Debug,
      std::to_string(counts_.given) + " frames given, " + std::to_string(counts_.dropped) +
          " dropped, " + std::to_string(counts_.corrupt) + " corrupt, " +
          std::to_string(counts_.odd) + " odd, " + std::to_string(counts_.restarts) +
          " restarts, " + std::to_string(counts_.losses) + " times unplugged");
}

Result<void> V4l2Source::set_size(int width, int height) {
  return FrameSchedule::check_size(width, height).map([&] { size_ = {width, height}; });
}

Result<FramePtr> V4l2Source::next(Time deadline) {
  while (true) {
    if (!stream_) look_again();
    bool sends = stream_ != nullptr;
    if (stream_) {
      const Result<Taken> taken = stream_->take_newest();
      if (taken && taken->any) last_sign_ = taken->now;
      if (taken && taken->newest) {
        Result<FramePtr> frame = picture_of(*taken->newest);
        stream_->give_back(*taken->newest);
        return frame;
      }
      const Result<void> alive = taken ? watch() : revive(taken.error());
      if (!alive) return tl::unexpected(alive.error());
      sends = taken.has_value();
    }
    const Time left = deadline - clock_.now();
    if (left <= Time(0)) return tl::unexpected(timeout(deadline));
    if (sends) {
      stream_->wait(std::min(left, kSlice));
    } else {
      calls_.wait(-1, std::min(left, kSlice));
    }
  }
}

void V4l2Source::look_again() {
  const Time now = calls_.monotonic();
  if (now - last_look_ < kBetweenLooks) return;
  last_look_ = now;
  try {
    stream_ = opener_.open_again();
  } catch (const ConfigError& error) {
    trouble_ = "unplugged, and not found again: " + error.text();
    return;
  }
  mode_ = stream_->mode();
  trouble_.clear();
  is_first_ = true;
  last_sign_ = calls_.monotonic();
  say(Severity::Warning, "is back");
}

tl::unexpected<Error> V4l2Source::lose(const std::string& reason) {
  stream_.reset();
  ++counts_.losses;
  last_look_ = calls_.monotonic() - kBetweenLooks;
  trouble_ = "unplugged";
  say(Severity::Warning, "unplugged (" + reason + "); it is looked for until it is back");
  return fail(Errc::Disconnected, "camera " + opener_.name() + ": unplugged (" + reason + ")");
}

Result<void> V4l2Source::revive(const Error& error) {
  if (error.code == Errc::Disconnected) return lose(error.what);
  const Time now = calls_.monotonic();
  if (now - last_restart_ < kBetweenRestarts) return {};
  last_restart_ = now;
  ++counts_.restarts;
  if (trouble_.empty()) say(Severity::Warning, error.what + "; streaming is started again");
  trouble_ = error.what;
  is_first_ = true;
  if (const Result<void> restarted = stream_->restart(); !restarted) {
    if (restarted.error().code == Errc::Disconnected) return lose(restarted.error().what);
    trouble_ = restarted.error().what;
  }
  return {};
}

Result<void> V4l2Source::watch() {
  const Time silent = calls_.monotonic() - last_sign_;
  if (silent < patience(mode_.fps)) return {};
  last_sign_ = calls_.monotonic();
  return revive({Errc::Timeout, "no frame for " + seconds_text(silent)});
}

void V4l2Source::note(const Oddities& odd) {
  if (counts_.odd++ > 0) return;
  say(Severity::Info,
      "sends JPEGs " + odd.text() + "; all their rows are there, and they are shown");
}

Result<FramePtr> V4l2Source::picture_of(const RawFrame& raw) {
  if (!trouble_.empty()) {
    trouble_.clear();
    say(Severity::Warning, "sends frames again");
  }
  const std::uint64_t number = number_of(raw);
  // A clock that was paused may put a moment from before the pause too early.
  last_time_ = std::max(last_time_, clock_.at(raw.taken));
  Result<Frame> frame =
      raw.is_damaged ? Result<Frame>(fail(Errc::Corrupt, "the driver marks the frame as damaged"))
                     : decoder_.decode({mode_.format, mode_.size, mode_.stride, raw.bytes}, size_);
  if (!frame) {
    ++counts_.corrupt;
    return fail(frame.error().code, "camera " + opener_.name() + ": " + frame.error().what);
  }
  if (frame->odd.any()) note(frame->odd);
  frame->time = last_time_;
  frame->sequence = number;
  ++counts_.given;
  return decoder_.share(*std::move(frame));
}

std::uint64_t V4l2Source::number_of(const RawFrame& raw) {
  std::uint64_t number = next_number_;
  if (!is_first_) {
    // Its 32 bits may wrap; a driver that does not count gives the same number again.
    const std::uint32_t passed = raw.sequence - last_sequence_;
    constexpr std::uint32_t kBackwards = 1U << 31U;
    const std::uint32_t missed = passed >= 1 && passed < kBackwards ? passed - 1 : 0;
    counts_.dropped += missed;
    number += missed;
  } else if (number > 0) {
    ++number;  // how many were lost is not known, but some were
  }
  is_first_ = false;
  last_sequence_ = raw.sequence;
  next_number_ = number + 1;
  return number;
}

Error V4l2Source::timeout(Time deadline) const {
  const std::string when = "no frame before " + seconds_text(deadline);
  return {Errc::Timeout, "camera " + opener_.name() + ": " + when +
                             (trouble_.empty() ? "" : " (" + trouble_ + ")")};
}

void V4l2Source::say(Severity severity, const std::string& text) const {
  log_.write(severity, "camera " + opener_.name() + ": " + text);
}

void check_v4l2_source(std::string_view rest, const SourceContext& context) {
  static_cast<void>(parse_camera_url(rest));
  if (context.clock == nullptr || !context.clock->is_virtual()) return;
  throw ConfigError({"--camera"},
                    "v4l2 gives frames in real time and the robot lives in virtual time; expected "
                    "both in real time: leave --fast out");
}

std::unique_ptr<Source> open_v4l2_source(std::string_view rest, const SourceContext& context) {
  return std::make_unique<V4l2Source>(system_video_calls(), parse_camera_url(rest), context);
}

}  // namespace eyebridge::camera
