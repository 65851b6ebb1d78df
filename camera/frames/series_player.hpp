#pragma once

#include <memory>
#include <optional>
#include <string>

#include "frames/frame_series.hpp"
#include "frames/frames_url.hpp"

namespace eyebridge::camera {

/// Brings a series of frames onto a robot's clock: which frame is due when, what is skipped, and
/// what comes after the last one. One thread at a time.
///
/// A recording has its times on that clock already; a folder and a video begin with the first frame
/// that is asked for.
class SeriesPlayer {
 public:
  /// `name` is for messages.
  SeriesPlayer(std::unique_ptr<FrameSeries> series, FramesUrl::End end, FramesUrl::Pick pick,
               std::string name);

  [[nodiscard]] Size size() const { return series_->size(); }

  /// The next frame that has not been given out, as Source::next(); its picture as the series has
  /// it. Fails with Timeout; Disconnected past the end; Corrupt, once, where a picture or the rest
  /// of the series is damaged.
  Result<Frame> next(Clock& clock, Time deadline);

 private:
  /// What is given out next, or was last; on the robot's clock.
  struct Slot {
    Time due{0};
    Time taken{0};
    std::uint64_t number = 0;
  };

  void begin(Time now);
  Result<void> advance(Time now);
  Result<void> go_on_after_end(Time now);
  void put(const SeriesEntry& entry);
  [[nodiscard]] std::optional<Time> due_after();
  Result<Frame> picture();
  [[nodiscard]] tl::unexpected<Error> ended() const;

  std::unique_ptr<FrameSeries> series_;
  FramesUrl::End end_;
  FramesUrl::Pick pick_;
  std::string name_;
  std::optional<Slot> slot_;  ///< None before the first.
  Time start_{0};             ///< Where the time 0 of the present round lies.
  Time first_due_{0};         ///< Of the first frame of a round, from its start.
  std::uint64_t base_ = 0;    ///< Number of the first frame of the present round.
  std::optional<std::uint64_t> first_given_;
  Time period_;           ///< Between the last two frames.
  bool given_ = false;    ///< The slot's frame is out.
  bool holding_ = false;  ///< The series is past its end, and its last picture goes on.
  bool ended_ = false;
  std::optional<Result<Frame>> held_;
};

}  // namespace eyebridge::camera
