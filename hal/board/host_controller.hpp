#pragma once

#include <mutex>
#include <optional>

#include "board/board_link.hpp"
#include "board/board_tables.hpp"
#include "board/drive_controller.hpp"
#include "board/host_drive.hpp"
#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal {

/// v-omega for a board that has none of its own: HostDrive over the speeds and encoders of motors 1
/// (left) and 2 (right), a hundred times a second.
class HostController final : public DriveController {
 public:
  /// `link` and `clock`, the one of its line, must outlive this.
  HostController(BoardLink& link, Clock& clock, const BoardDriveShape& shape);

  Result<void> set_speed(const Twist& twist) override;
  Result<void> start(const DriveGoal& goal) override;
  Result<DriveStatus> status() override;
  Result<Twist> measured_twist() override;
  Result<Pose> odometry() override;
  Result<void> set_odometry(const Pose& pose) override;
  void release() override;
  void restarted() override;
  void step() override;

 private:
  struct TimedCounts {
    WheelCounts wheels;
    Time at{0};
  };

  Result<TimedCounts> read_counts();
  /// A count that did not take much longer than others, of three at most: of one that did nobody
  /// knows when the board counted.
  Result<BoardCount> prompt_count(int encoder);
  [[nodiscard]] Result<void> check() const;                // under mutex_
  [[nodiscard]] Result<void> check_line() const;           // under mutex_
  void note(const Result<TimedCounts>& counts, Time now);  // under mutex_
  void stand();                                            // likewise
  /// What to send while the encoders are not heard; nothing where nothing can be.
  std::optional<WheelSpeeds> speeds_unheard(const Error& why, Time now);  // under mutex_
  void send(const WheelSpeeds& speeds, Time now);                         // under sending_

  BoardLink& link_;
  Clock& clock_;
  // Only step()'s:
  std::optional<BoardCount> right_;  ///< The one before.
  Time usual_answer_{0};             ///< How long a count takes.
  std::mutex sending_;               // taken before mutex_: after release() no speed is sent
  std::mutex mutex_;                 // of all below
  HostDrive drive_;
  Time heard_;                    ///< When the encoders were read last.
  std::optional<Error> trouble_;  ///< Why they cannot be read any more.
  bool goal_lost_ = false;        ///< A restart of the board ended it, or silence.
  bool standing_ = false;         ///< By the last command, or since the encoders are silent.
  std::optional<WheelSpeeds> sent_;
  Time sent_at_{0};
};

}  // namespace eyebridge::hal
