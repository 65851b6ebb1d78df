#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>

#include "eyebridge/base/log.hpp"
#include "eyebridge/bridges/can/lidar.hpp"
#include "eyebridge/bridges/can/messages.hpp"
#include "eyebridge/bridges/can/zones.hpp"
#include "eyebridge/bridges/can_bus.hpp"
#include "eyebridge/bridges/client/robot_watch.hpp"
#include "eyebridge/bridges/client/sender_watch.hpp"
#include "eyebridge/bridges/guard/line_guard.hpp"

namespace eyebridge::bridges {

/// What happened between a client and its robot since the client was made.
struct CanClientStatistics {
  std::uint64_t corrupt = 0;       ///< Frames that are too short or have impossible values.
  std::uint64_t enables = 0;       ///< Enable commands.
  std::uint64_t move_repeats = 0;  ///< Moves that were sent again for want of an echo.
  CanStatistics bus{};
};

/// How a movement that was sent stands.
enum class MoveProgress {
  Sent,     ///< Not echoed yet.
  Running,  ///< Under way.
  Done,     ///< Ended as it should.
  Failed,   ///< Aborted, never echoed, or the robot was lost since.
};

/// One robot on a CAN bus: latest status, commands that live as long as the program does.
///
/// Heartbeat and repeated set-points are sent, and frames taken, by a thread of its own (start())
/// or by the caller (pump()), never by both. All else: any thread. When the robot is lost every
/// command is dropped and every call fails with Disconnected until it is ready again, at speed 0;
/// generation() tells, and restarts() whether it forgot its pose and its counts meanwhile. Poses,
/// speeds and counts that somebody else sends under the robot's identifiers are not used, and a
/// warning names the identifier.
class CanClient {
 public:
  /// `node` is 1 … 14. `clock`, the one of `bus`, and `log` must outlive this.
  CanClient(std::unique_ptr<CanBus> bus, int node, Clock& clock, LogSink& log);
  /// Speed 0, motors 0 and standby go out; the thread ends.
  ~CanClient();
  CanClient(const CanClient&) = delete;
  CanClient& operator=(const CanClient&) = delete;

  /// Starts the thread "eb:can".
  void start();
  /// Does what the thread would until `until`. Only without start().
  void pump(Time until);
  /// From now on a LineGuard stops the robot, by an emergency stop, when this process is gone
  /// without stop(). Fails with Disconnected; Unsupported where the bus has no socket.
  Result<void> guard();
  /// Waits until the robot is ready, has told what it is, and every cyclic message has come, and a
  /// scan or a reading of a range matrix from one that can; at most for `patience`. Fails with what
  /// is missing.
  Result<void> wait_ready(Time patience);

  /// The last status of a kind. Fails with Disconnected or Corrupt while the robot is not ready;
  /// with Timeout when it is older than four periods of it (at least 300 ms).
  /// `at`, when not null, becomes the time at which it came.
  template <class Status>
  Result<Status> latest(Time* at = nullptr) const {
    const std::lock_guard lock(mutex_);
    const auto& entry = std::get<Latest<Status>>(latest_);
    return check_age(can::spec_of<Status>(), entry.at).map([&] {
      if (at != nullptr) *at = *entry.at;
      return entry.value;
    });
  }
  /// The last complete scan, copied into `out`. Fails as latest() does; Timeout: none in a second.
  Result<void> latest_scan(can::LidarScan& out) const;
  /// Whether the robot says that it can scan, or has ever announced a scan.
  [[nodiscard]] bool has_lidar() const;
  /// The last whole reading of range matrix `id`. Fails as latest() does; Timeout: none in a
  /// second.
  [[nodiscard]] Result<can::Zones> latest_zones(int id) const;
  /// Whether the robot says that it has range matrix `id`, or has ever sent a reading of it.
  [[nodiscard]] bool has_range_matrix(int id) const;

  /// Drives at this speed from now on; repeated every 50 ms.
  Result<void> drive(std::int16_t v_mm_s, std::int16_t w_cdeg_s);
  /// Starts a movement; `command.seq` is chosen here. Repeated until the robot echoes it.
  Result<void> move(can::MoveCommand command);
  /// Of the last move().
  [[nodiscard]] Result<MoveProgress> move_progress() const;
  /// Motor 1 … 4: `value` percent, or ticks per 10 ms, by `mode` EYECAN_MOTOR_…; repeated every
  /// 50 ms, together with what the other motors were told.
  Result<void> motor(int motor, std::int8_t value, std::uint8_t mode);
  /// Gains of a motor; told again when the robot has restarted.
  Result<void> pid(const can::PidCommand& gains);
  /// Servo 1 … 14 to 0 … 255; repeated every 100 ms. The others of its bank are in the middle until
  /// they are told.
  Result<void> servo(int servo, std::uint8_t position);
  /// Sets the robot's odometry and waits until it says so, at most 200 ms. A pose that is less than
  /// 60 mm and 20 degrees from the one before takes 25 ms: no sooner can the two be told apart.
  Result<void> set_pose(const can::PoseCommand& pose);
  /// A command that is said once.
  template <class Command>
  Result<void> say(const Command& command) {
    return send_ready(can::encode(node_, command));
  }
  /// Stops driving and all motors, whatever the state. Fails when the robot is not heard, or
  /// nothing can be sent: its own watchdog has to do.
  Result<void> stop();
  /// Stops the robot now, repeated every 100 ms until release(); EYECAN_ESTOP_….
  void emergency_stop(std::uint8_t reason);
  /// Ends it: the robot is enabled again 550 ms later, at speed 0.
  void release();

  [[nodiscard]] RobotWatch::Phase phase() const;
  /// Grows whenever the robot's commands were dropped.
  [[nodiscard]] std::uint32_t generation() const;
  /// Grows whenever the robot forgot what it knew: it was switched off and on, or is another one.
  [[nodiscard]] std::uint32_t restarts() const;
  [[nodiscard]] CanClientStatistics statistics() const;

 private:
  template <class Status>
  struct Latest {
    Status value{};
    std::optional<Time> at;  ///< None: it has never come.
  };
  using Statuses =
      std::tuple<Latest<can::PoseStatus>, Latest<can::SpeedStatus>, Latest<can::Encoder12Status>,
                 Latest<can::Encoder34Status>, Latest<can::PsdAStatus>, Latest<can::PsdBStatus>,
                 Latest<can::PsdRawStatus>, Latest<can::DigitalStatus>, Latest<can::AnalogAStatus>,
                 Latest<can::AnalogBStatus>, Latest<can::BoardStatus>, Latest<can::VersionStatus>,
                 Latest<can::FaultStatus>>;
  /// What came last, until other messages of the same period show that the robot sent it.
  using Pending =
      std::tuple<Latest<can::PoseStatus>, Latest<can::SpeedStatus>, Latest<can::Encoder12Status>>;
  template <class Status, class Tuple>
  struct IsKept;
  template <class Status, class... Entries>
  struct IsKept<Status, std::tuple<Entries...>>
      : std::disjunction<std::is_same<Latest<Status>, Entries>...> {};
  enum class Mode { Idle, Standing, Speed, Move, Motors };
  struct MotorPoint {
    bool used = false;
    std::uint8_t mode = 0;
    std::int8_t value = 0;
  };
  struct Command {
    Mode mode = Mode::Idle;
    can::SpeedCommand speed{};
    can::MoveCommand move{};
    bool move_echoed = false;
    bool move_failed = false;
    Time move_sent{0};
    std::array<MotorPoint, 4> motors{};
  };
  /// Frames that are due together, without allocating.
  struct Outbox {
    std::array<CanFrame, 16> frames{};
    std::size_t count = 0;
    void add(const Result<CanFrame>& frame) {
      if (frame && count < frames.size()) frames[count++] = *frame;
    }
  };

  void run();
  Time tick();
  void take(const CanFrame& frame);
  void take_message(const can::AnyMessage& message, Time now);  // under mutex_
  void keep_nothing(int function, Time now);                    // of a bad frame; under mutex_
  void keep_status(const can::AnyMessage& message, Time now);   // under mutex_
  template <class Status>
  void keep(const Status& status, Time now);                 // under mutex_
  void keep_followed(Time now);                              // under mutex_
  void name_other_senders(Time now);                         // under mutex_
  void note_other_host(std::string_view message, Time now);  // under mutex_
  void note_speed(const can::SpeedStatus& status);           // under mutex_
  /// Whether it may be the answer to the move that was told last.
  [[nodiscard]] bool echoes(const can::SpeedStatus& status) const;  // under mutex_
  void note_fault(const can::FaultStatus& fault);                   // under mutex_
  void follow_watch(std::uint32_t before);                          // under mutex_
  void add_set_points(Outbox& out);                                 // under mutex_
  void add_parameters(Outbox& out) const;                           // under mutex_
  void add_zero(Outbox& out);                                       // under mutex_
  void tell_guard(bool turning);                                    // under sending_
  Result<void> check_age(const can::MessageSpec& spec, std::optional<Time> at) const;
  Result<void> check_ready() const;          // under mutex_
  Result<void> send(const CanFrame& frame);  // under sending_
  Result<void> send_all(const Outbox& out);  // under sending_
  Result<void> send_ready(const Result<CanFrame>& frame);
  bool wait_for(const std::function<bool()>& done, Time deadline);
  [[nodiscard]] std::string missing() const;                    // under mutex_
  [[nodiscard]] bool is_capable_of(unsigned capability) const;  // under mutex_
  void take_zones(const can::ZoneChunk& chunk, Time now);       // under mutex_
  [[nodiscard]] CanFrame version_request() const;
  std::uint8_t next_seq() { return seq_ = static_cast<std::uint8_t>(seq_ + 1U); }

  const std::unique_ptr<CanBus> bus_;
  std::unique_ptr<LineGuard> guard_;  // under sending_
  const int node_;
  const std::string who_;  ///< "can0: robot 1"
  Clock& clock_;
  LogSink& log_;
  std::thread thread_;

  std::mutex sending_;  // taken before mutex_; frames leave in the order of their decisions
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  RobotWatch watch_;
  SenderWatch senders_;
  Statuses latest_;
  Pending pending_;
  Command command_;
  std::array<std::optional<can::PidCommand>, 4> gains_;
  std::array<std::optional<can::ServoCommand>, 2> servos_;
  std::unique_ptr<can::LidarAssembler> lidar_;
  can::LidarScan scan_{};
  std::optional<Time> scan_at_;
  bool has_lidar_ = false;
  struct RangeMatrix {
    can::ZoneAssembler assembler;
    Time chunk_at{0};
    can::Zones zones{};
    std::optional<Time> at;  ///< Of `zones`.
  };
  std::array<RangeMatrix, can::kMostMatrices> range_matrices_;  ///< 1 is the first.
  std::optional<std::uint8_t> emergency_;
  Time next_heartbeat_{0};
  Time next_point_{0};
  Time next_servo_{0};
  Time next_report_{0};
  std::uint8_t seq_ = 0;
  bool ending_ = false;
  CanClientStatistics statistics_;
};

}  // namespace eyebridge::bridges
