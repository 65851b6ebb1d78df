#include "frames/series_player.hpp"

#include <algorithm>

namespace eyebridge::camera {

SeriesPlayer::SeriesPlayer(std::unique_ptr<FrameSeries> series, FramesUrl::End end,
                           FramesUrl::Pick pick, std::string name)
    : series_(std::move(series)),
      end_(end),
      pick_(pick),
      name_(std::move(name)),
      period_(series_->period()) {}

Result<Frame> SeriesPlayer::next(Clock& clock, Time deadline) {
  if (ended_) return ended();
  if (!slot_) {
    begin(clock.now());
  } else if (given_) {
    if (Result<void> moved = advance(clock.now()); !moved) return tl::unexpected(moved.error());
  }
  given_ = false;
  if (slot_->due > deadline) {
    clock.wait_until(deadline);
    return fail(Errc::Timeout, "camera: no frame before " + std::to_string(to_seconds(deadline)) +
                                   " s, the next is due at " +
                                   std::to_string(to_seconds(slot_->due)) + " s");
  }
  clock.wait_until(slot_->due);
  while (pick_ == FramesUrl::Pick::Newest) {
    const std::optional<Time> after = due_after();
    if (!after || *after > clock.now()) break;
    if (Result<void> moved = advance(clock.now()); !moved) return tl::unexpected(moved.error());
  }
  given_ = true;
  Result<Frame> frame = picture();
  if (!frame) return frame;
  if (!first_given_) first_given_ = slot_->number;
  frame->time = slot_->taken;
  frame->sequence = slot_->number - *first_given_;
  return frame;
}

void SeriesPlayer::begin(Time now) {
  const SeriesEntry first = *series_->entry(0);  // a series without frames cannot be opened
  if (!series_->is_on_robots_clock()) start_ = now - first.due;
  first_due_ = first.due;
  put(first);
}

/// When the frame after the present one is due; none when there will be none.
std::optional<Time> SeriesPlayer::due_after() {
  if (!holding_) {
    if (const std::optional<SeriesEntry> entry = series_->entry(1)) return start_ + entry->due;
  }
  if (end_ == FramesUrl::End::Stop) return std::nullopt;
  return slot_->due + period_;
}

Result<void> SeriesPlayer::advance(Time now) {
  if (holding_) return go_on_after_end(now);
  const bool is_last = !series_->entry(1);
  if (is_last && end_ == FramesUrl::End::Hold && !held_) held_ = series_->picture();
  series_->advance();
  if (const std::optional<SeriesEntry> entry = series_->entry(0)) {
    put(*entry);
    return {};
  }
  return go_on_after_end(now);
}

Result<void> SeriesPlayer::go_on_after_end(Time now) {
  switch (end_) {
    case FramesUrl::End::Stop:
      ended_ = true;
      return ended();
    case FramesUrl::End::Hold: {
      holding_ = true;
      // Whoever was away for long gets the present frame, not each one since.
      const Time late = pick_ == FramesUrl::Pick::Newest ? now - slot_->due : Time{0};
      const Time::rep steps = std::max<Time::rep>(1, late / period_);
      slot_->due += steps * period_;
      slot_->taken += steps * period_;
      slot_->number += static_cast<std::uint64_t>(steps);
      return {};
    }
    case FramesUrl::End::Loop:
      break;
  }
  // Likewise with whole rounds.
  const Time round = slot_->due + period_ - start_ - first_due_;
  const Time late = now - (start_ + first_due_);
  const Time::rep rounds =
      pick_ == FramesUrl::Pick::Newest ? std::max<Time::rep>(1, late / round) : 1;
  start_ += rounds * round;
  base_ += static_cast<std::uint64_t>(rounds) * (slot_->number + 1 - base_);
  series_->rewind();
  const std::optional<SeriesEntry> first = series_->entry(0);
  if (!first) {
    ended_ = true;
    return ended();
  }
  put(*first);
  return {};
}

void SeriesPlayer::put(const SeriesEntry& entry) {
  const Time due = start_ + entry.due;
  if (slot_ && due > slot_->due) period_ = due - slot_->due;
  slot_ = Slot{due, start_ + entry.taken, base_ + entry.number};
}

Result<Frame> SeriesPlayer::picture() { return holding_ ? *held_ : series_->picture(); }

tl::unexpected<Error> SeriesPlayer::ended() const {
  const std::string frames =
      slot_ ? " at " + std::to_string(to_seconds(slot_->due)) + " s" : std::string();
  return fail(Errc::Disconnected,
              "camera: " + name_ + " has ended" + frames + " (end=loop or end=hold would go on)");
}

}  // namespace eyebridge::camera
