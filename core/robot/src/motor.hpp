#pragma once

#include <cstdint>

namespace eyebridge::robot {

/// e^-x for x >= 0, from + - * / alone: same bits on every machine. Relative error below 1e-12.
double decay_of(double x);

/// What the two motors of a robot have in common.
struct MotorModel {
  double dt = 0.01;    ///< Length of a step, seconds.
  double top = 1.7;    ///< Speed of the wheel's rim at full duty, metres per second.
  double decay = 0.0;  ///< What is left of a difference in speed after a step: e^(-dt / T).
  double lag = 0.0;    ///< T (1 - decay): seconds of a difference that a step's travel keeps.
  double time_constant = 0.0;  ///< T, seconds; 0 follows at once.
  double ticks_per_metre = 1;  ///< Encoder ticks a metre of the rim.
};

/// What set_motor_duty() and set_motor_speed() want of a wheel.
struct MotorCommand {
  double speed = 0.0;       ///< Of the rim, metres per second.
  bool controlled = false;  ///< By PID; else as duty.
};

/// Gains of the speed controller as the IO7 board takes them, 0 … 255 each.
struct PidGains {
  int p = 4;
  int i = 1;
  int d = 1;
};

/// A motor with its wheel, speed controller and encoder.
///
/// The motor is a first-order lag: its speed goes to duty * top. The controller feeds the wanted
/// speed forward, which is exact in the steady state, and adds PID on how far the last step missed
/// its target; a motor without lag never misses, so it is driven exactly.
class Wheel {
 public:
  /// Uncontrolled: towards `speed` at the rim, metres per second, as the duty for it would do.
  /// Returns the rim's travel in this step, metres.
  double drive(double speed, const MotorModel& model);
  /// Speed-controlled: likewise, with PID.
  double drive_controlled(double speed, const MotorModel& model);
  /// Counts `travel` metres on the encoder; with `held` the wheel is now as fast as that, and the
  /// controller does not wind up against the obstacle.
  void turn(double travel, bool held, const MotorModel& model);
  /// Stands still at once; the encoder keeps its count.
  void halt();

  /// True when the same command gives the same travel for ever: it has the speed it had before the
  /// last drive, `before`, and nothing is left to correct.
  [[nodiscard]] bool settled(double before) const {
    return speed_ == before && last_target_ == speed_ && last_error_ == 0.0 && integral_ == 0.0;
  }

  void set_gains(const PidGains& gains) { gains_ = gains; }
  [[nodiscard]] double speed() const { return speed_; }    ///< Of the rim, metres per second.
  [[nodiscard]] double travel() const { return travel_; }  ///< Since the start, metres.
  /// After steps of which somebody else kept account.
  void set_travel(double travel) { travel_ = travel; }
  /// How far the rim still goes when the controller is told to stand still, metres.
  [[nodiscard]] double rolling(const MotorModel& model) const;
  /// Whole ticks since the start, to the nearest one, without those that were missed.
  [[nodiscard]] std::int64_t raw_ticks(const MotorModel& model) const;
  [[nodiscard]] std::int64_t ticks(const MotorModel& model) const {
    return raw_ticks(model) - zero_ticks_;
  }
  void reset_ticks(const MotorModel& model) { zero_ticks_ = raw_ticks(model); }
  /// The encoder has not counted `ticks` of those that went by; negative ones of a way back.
  void miss(std::int64_t ticks) { missed_ticks_ += ticks; }

 private:
  double speed_ = 0.0;
  double travel_ = 0.0;
  double last_target_ = 0.0;  // metres per second
  double last_error_ = 0.0;   // metres per second
  double integral_ = 0.0;     // metres per second, summed over periods of the board's controller
  std::int64_t zero_ticks_ = 0;
  std::int64_t missed_ticks_ = 0;
  PidGains gains_;
};

}  // namespace eyebridge::robot
