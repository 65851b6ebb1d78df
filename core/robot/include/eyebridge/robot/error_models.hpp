#pragma once

#include <memory>
#include <vector>

namespace eyebridge::robot {

// What is wrong with the devices of a robot, one plain struct a kind of device. All zero, the
// default, is a device without errors, and costs nothing: no random number is drawn for it. Each
// has perfect(), true when it changes nothing, and scaled(share), the same with `share` (0 none …
// 1 all of it) of every amount. Probabilities and shares are 0 … 1; metres, radians, seconds.

/// Gaussian error of a reading: sigma = `sigma` + `sigma_relative` * |value|, mean = `bias`.
struct GaussianError {
  double bias = 0.0;            ///< In the unit of the reading.
  double sigma = 0.0;           ///< In the unit of the reading, >= 0.
  double sigma_relative = 0.0;  ///< Fraction of the reading, >= 0.

  [[nodiscard]] bool perfect() const { return bias == 0 && sigma == 0 && sigma_relative == 0; }
  [[nodiscard]] GaussianError scaled(double share) const;
  friend bool operator==(const GaussianError&, const GaussianError&) = default;
};

/// What a distance sensor can say at all: the entries of its table in an HDT file. A cheap value:
/// copies share the entries.
class RangeTable {
 public:
  RangeTable() = default;
  /// `metres` by raw value, any order. Entries that are not positive, and those of 9.999 m and
  /// more, which say that nothing is seen, are left out.
  explicit RangeTable(const std::vector<double>& metres);

  [[nodiscard]] bool empty() const { return levels_ == nullptr; }
  /// The entry nearest to `range`, the shorter one of two; `out_of_range` where that is farther
  /// than the table reaches by more than half of its last step. `range` itself without a table.
  [[nodiscard]] double nearest(double range, double out_of_range) const;
  /// The largest range for which nearest() gives `reading` or less; minus infinity when there is
  /// none. The table is not empty.
  [[nodiscard]] double upper_edge(double reading) const;
  /// Every entry once, ascending.
  [[nodiscard]] std::vector<double> levels() const;
  friend bool operator==(const RangeTable& a, const RangeTable& b) {
    return a.levels_ == b.levels_ || a.levels() == b.levels();
  }

 private:
  std::shared_ptr<const std::vector<double>> levels_;  // thousands of robots of one type
};

/// Of a distance sensor (PSD), on readings within its reach: Gaussian noise first, then the
/// rounding to what its table can say, as on a robot, where the noise is there before the
/// converter; then some readings are lost.
struct RangeError : GaussianError {
  double dropout = 0.0;    ///< Probability that a reading is out of range instead.
  bool quantised = false;  ///< Rounded by the sensor's RangeTable, if it has one.
  /// Of ultrasound only: probability, for each other ultrasound sensor in earshot, that a pulse of
  /// it comes in while this one listens (Simulation::cross_talkers()).
  double cross_talk = 0.0;
  /// 1/m: so much times the square of the range is added to sigma. Noise of a triangulating sensor
  /// (infrared) is that of the place of a spot of light, and its range is one over that place.
  double sigma_quadratic = 0.0;

  [[nodiscard]] bool perfect() const {
    return GaussianError::perfect() && dropout == 0 && !quantised && cross_talk == 0 &&
           sigma_quadratic == 0;
  }
  /// Standard deviation of readings of something `range` metres away, metres.
  [[nodiscard]] double sigma_at(double range) const {
    return sigma + sigma_relative * range + sigma_quadratic * range * range;
  }
  [[nodiscard]] RangeError scaled(double share) const;
  friend bool operator==(const RangeError&, const RangeError&) = default;
};

/// Of an infrared proximity switch.
struct ProximityError {
  double flip = 0.0;  ///< Probability of a wrong answer, either way.

  [[nodiscard]] bool perfect() const { return flip == 0; }
  [[nodiscard]] ProximityError scaled(double share) const { return {flip * share}; }
  friend bool operator==(const ProximityError&, const ProximityError&) = default;
};

/// Of a bumper.
struct BumperError {
  double miss = 0.0;  ///< Probability that a contact is not seen when asked for.

  [[nodiscard]] bool perfect() const { return miss == 0; }
  [[nodiscard]] BumperError scaled(double share) const { return {miss * share}; }
  friend bool operator==(const BumperError&, const BumperError&) = default;
};

/// Of a LIDAR, ray by ray. Rays that meet nothing have no noise.
struct LidarError : GaussianError {
  double dropout = 0.0;  ///< Probability that a ray that meets something reads the full range.

  [[nodiscard]] bool perfect() const { return GaussianError::perfect() && dropout == 0; }
  [[nodiscard]] LidarError scaled(double share) const;
  friend bool operator==(const LidarError&, const LidarError&) = default;
};

/// Of a range matrix, zone by zone.
struct RangeMatrixError : LidarError {
  [[nodiscard]] RangeMatrixError scaled(double share) const { return {LidarError::scaled(share)}; }
  friend bool operator==(const RangeMatrixError&, const RangeMatrixError&) = default;
};

/// Of a compass; radians. The sum of heading and error is wrapped.
struct CompassError : GaussianError {
  [[nodiscard]] CompassError scaled(double share) const { return {GaussianError::scaled(share)}; }
  friend bool operator==(const CompassError&, const CompassError&) = default;
};

/// Of a gyroscope; radians per second.
struct GyroscopeError : GaussianError {
  /// The bias is a random walk: in t seconds it strays by a normally distributed amount of this
  /// times sqrt(t); radians per second, per root of a second, >= 0. It starts at `bias`.
  double drift = 0.0;

  [[nodiscard]] bool perfect() const { return GaussianError::perfect() && drift == 0; }
  [[nodiscard]] GyroscopeError scaled(double share) const {
    return {GaussianError::scaled(share), drift * share};
  }
  friend bool operator==(const GyroscopeError&, const GyroscopeError&) = default;
};

/// Of an accelerometer, of each axis by itself; metres per second squared.
struct AccelerometerError : GaussianError {
  [[nodiscard]] AccelerometerError scaled(double share) const {
    return {GaussianError::scaled(share)};
  }
  friend bool operator==(const AccelerometerError&, const AccelerometerError&) = default;
};

/// Of actuators, encoders and with them odometry; drawn anew for every step of the simulation.
struct DriveError {
  double linear_sigma = 0.0;   ///< Gaussian, fraction of each step's travel.
  double angular_sigma = 0.0;  ///< Gaussian, fraction of each step's turn.
  double left_scale = 0.0;     ///< Systematic: the left wheel's travel is 1 + this times what its
  double right_scale = 0.0;    ///< encoder says; likewise right (unequal wheel diameters).
  bool encoder_quantised = false;  ///< Odometry sees whole encoder ticks only, not exact travel.
  double slip = 0.0;  ///< Probability that a wheel finds no hold in a step: it turns, and its
                      ///< encoder counts, but it does not take its side of the robot along.
  double encoder_miss = 0.0;  ///< Probability that a tick is not counted; implies whole ticks.

  [[nodiscard]] bool perfect() const { return *this == DriveError{}; }
  /// True when the same turn of the wheels takes the robot to different places.
  [[nodiscard]] bool moves_by_chance() const {
    return linear_sigma != 0 || angular_sigma != 0 || slip > 0;
  }
  /// True when odometry goes by the encoder's count instead of the exact travel.
  [[nodiscard]] bool counts_ticks() const { return encoder_quantised || encoder_miss > 0; }
  [[nodiscard]] DriveError scaled(double share) const;
  friend bool operator==(const DriveError&, const DriveError&) = default;
};

/// Of a camera's pictures, in the order in which it happens to them: blur by the lens, exposure,
/// noise of the sensor, then pixels that are lost.
struct CameraError {
  double salt_and_pepper = 0.0;  ///< Share of the pixels turned black or white, as many of each.
  double sigma = 0.0;            ///< Gaussian noise of every channel by itself, 0 … 255.
  double coloured = 0.0;  ///< Share of the pixels of a random colour: EyeSim's "100s & 1000s".
  double blur = 0.0;  ///< Standard deviation, pixels of a picture 320 wide (in a wider one more).
  double exposure = 0.0;        ///< Systematic, in stops: +1 is twice as bright.
  double exposure_sigma = 0.0;  ///< Gaussian, in stops, drawn once a picture: flicker.

  [[nodiscard]] bool perfect() const { return *this == CameraError{}; }
  [[nodiscard]] CameraError scaled(double share) const;
  friend bool operator==(const CameraError&, const CameraError&) = default;
};

/// Of messages to a robot's radio.
struct RadioError {
  double loss = 0.0;     ///< Share of the messages that get lost.
  double delay = 0.0;    ///< Seconds until one arrives.
  double jitter = 0.0;   ///< Seconds more, evenly spread from 0 to this: messages may overtake.
  double corrupt = 0.0;  ///< Share of the messages in which one bit is flipped.
  double range = 0.0;    ///< Metres beyond which nothing arrives; 0 is no limit.

  [[nodiscard]] bool perfect() const { return *this == RadioError{}; }
  /// The range grows as the share gets smaller: half the error is twice as far.
  [[nodiscard]] RadioError scaled(double share) const;
  friend bool operator==(const RadioError&, const RadioError&) = default;
};

}  // namespace eyebridge::robot
