#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "eyebridge/base/drive_goal.hpp"
#include "eyebridge/base/hash.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/robot/robot_model.hpp"
#include "eyebridge/world/world.hpp"

namespace eyebridge::robot {

/// Index of a robot in its Simulation: 0 for the first.
using RobotIndex = std::uint32_t;

/// Where the running movement stands.
enum class DriveState {
  Idle,     ///< Nothing under way, or speed mode: nothing that could end.
  Driving,  ///< A goal is under way.
  Failed,   ///< The last goal was given up: stalled for longer than the time-out.
};

/// Which wheels are held by an obstacle, along which the robot does not slide: bit 0 left, bit 1
/// right.
enum StallMask : unsigned { kStallNone = 0, kStallLeft = 1, kStallRight = 2, kStallBoth = 3 };

/// Something that ran into something: what the environment reports, once a contact.
struct CollisionEvent {
  double time = 0.0;                         ///< Seconds since start, of the step's end.
  world::BodyId body = 0;                    ///< Who ran into it.
  std::optional<RobotIndex> robot{};         ///< If that is a robot.
  world::BodyId with_body = world::kNoBody;  ///< kNoBody: a wall.
  std::optional<RobotIndex> with_robot{};    ///< If that is a robot.
  Vec2 place{};                              ///< Of the contact, in the world, metres.
  Pose pose{};                               ///< Of `body`, at the step's end.
  /// If `body` is an object, its number, from 0 (world::World::object_of()); and the same of
  /// `with_body`.
  std::optional<std::size_t> object{};
  std::optional<std::size_t> with_object{};

  [[nodiscard]] bool with_wall() const { return with_body == world::kNoBody; }
};

/// How many collisions a simulation keeps at least, if there were so many.
inline constexpr std::size_t kCollisionsKept = 10000;

/// How many servos a robot has room for.
inline constexpr unsigned kServoCount = 16;

/// Settings of a simulation.
struct SimulationSettings {
  double step = 0.01;          ///< Seconds; fixed.
  std::uint64_t seed = 1;      ///< Every robot and device draws from its own stream of it.
  double stall_timeout = 2.0;  ///< A goal that is stalled this long fails, seconds.
  /// A robot that meets something slides on along it; else it stands there until its way is free.
  bool slides = true;
};

/// A world with robots that move: commands in, readings out, one fixed step at a time.
///
/// Pipeline of a robot, each step: v-omega commands -> ramps -> wheel targets (PID) -> motors ->
/// wheels -> arc -> collision -> pose; encoders and odometry come from the wheels. "Perfect" and
/// "with errors" are the same code with other parameters. Same calls, same seed: same bits. Not
/// thread-safe. Indices of robots, motors, servos and sensors that do not exist throw
/// std::out_of_range; numbers are finite. Metres, radians, seconds.
class Simulation {
 public:
  /// Throws std::invalid_argument when the step is not positive and finite, or the time-out
  /// negative; an infinite time-out never comes.
  Simulation(std::shared_ptr<const world::WorldModel> model, const SimulationSettings& settings);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Adds a robot at `pose`. Throws std::invalid_argument when it would stand in something, or when
  /// its model cannot be (a wheel of diameter 0, a negative speed).
  RobotIndex add_robot(const RobotModel& model, const Pose& pose);
  /// Takes a robot out of the world, for good: its motors stop and its body is gone. Indices of
  /// others stay and its own is not used again; what it is asked for is as it was when it left, and
  /// commands move nothing.
  void remove_robot(RobotIndex robot);
  /// False once it was removed.
  [[nodiscard]] bool is_there(RobotIndex robot) const;
  /// With those that were removed.
  [[nodiscard]] std::size_t robot_count() const;
  [[nodiscard]] const RobotModel& model(RobotIndex robot) const;
  [[nodiscard]] world::BodyId body(RobotIndex robot) const;
  /// From now on the devices of `robot` err as those of `like`, a model with the same devices: its
  /// own with set_errors() or scale_errors() of error_presets.hpp, say. Streams of random numbers
  /// go on where they are. Throws std::invalid_argument when `like` has other devices.
  void set_errors(RobotIndex robot, const RobotModel& like);

  /// Advances time by settings().step.
  void step();
  [[nodiscard]] double time() const;
  [[nodiscard]] const SimulationSettings& settings() const;

  // Truth.
  [[nodiscard]] Pose pose(RobotIndex robot) const;
  /// Moves a robot by hand, at rest; odometry does not notice. The running command goes on. One
  /// that was removed stays away.
  void set_pose(RobotIndex robot, const Pose& pose);
  [[nodiscard]] Twist twist(RobotIndex robot) const;  ///< As driven in the last step.
  /// The same of the robot's centre with its sideways part, which only some drives have.
  [[nodiscard]] HolonomicTwist body_twist(RobotIndex robot) const;
  /// Where the front wheels of an Ackermann drive, or all of a synchro one, point: radians from the
  /// robot's front, counter-clockwise. 0 for all others.
  [[nodiscard]] double steering(RobotIndex robot) const;
  /// How far the underside of a submarine is above the floor, metres: 0 … depth of the water less
  /// its height, at which it starts. 0 for all others.
  [[nodiscard]] double altitude(RobotIndex robot) const;
  /// How far the upper side of a submarine is below the surface, metres, >= 0; nothing for others.
  [[nodiscard]] std::optional<double> depth(RobotIndex robot) const;
  /// Moves a submarine up or down by hand, without vertical speed then; clamped to the water. Its
  /// altitude after that; does nothing to others. `altitude` is finite.
  double set_altitude(RobotIndex robot, double altitude);

  // v-omega driving. Speeds and accelerations are clamped to the model's limits.
  void set_speed(RobotIndex robot, const Twist& twist);  ///< Until the next command.
  /// The same for drives that can go sideways: `twist` in the robot's frame. Too much of it for a
  /// wheel is scaled down as a whole. Differential and Ackermann drives leave the sideways part
  /// out. Synchro ones have no turn: they steer their wheels there, the shorter way, and drive.
  void set_twist(RobotIndex robot, const HolonomicTwist& twist);
  /// Replaces whatever is under way; the ramp starts from the speed the robot has. A goal of zero
  /// length, or with speed 0, is done at once and stops the robot. Ends exactly by odometry. A
  /// turn only slows down the way the robot had before, a straight the turn: neither is undone.
  void drive(RobotIndex robot, const DriveGoal& goal);
  [[nodiscard]] DriveState drive_state(RobotIndex robot) const;
  [[nodiscard]] double remaining(
      RobotIndex robot) const;  ///< Distance to go, metres, >= 0; turns: 0.
  /// StallMask. A stall ends when the robot moves again or with a new command; after a goal that
  /// failed it stays until then.
  [[nodiscard]] unsigned stalled(RobotIndex robot) const;
  /// Whether a command tells its motors to turn, or they still slow down.
  [[nodiscard]] bool is_told_to_move(RobotIndex robot) const;
  void stop(RobotIndex robot);  ///< Motors off at once, without a ramp; lagging ones run down.

  // Odometry, from the wheels. Starts at (0, 0, 0) where the robot is placed.
  [[nodiscard]] Pose odometry(RobotIndex robot) const;
  void set_odometry(RobotIndex robot, const Pose& pose);
  [[nodiscard]] Twist measured_twist(RobotIndex robot) const;

  // Wheels: which is which, and how many, is in DriveKind (differential: 0 left, 1 right). Using
  // one, or the steering, takes the robot out of v-omega control; not so vertical thrusters.
  /// `duty` -1 … 1 of the model's top wheel speed; beyond, it is clamped without an error.
  void set_motor_duty(RobotIndex robot, unsigned motor, double duty);
  /// PID-controlled wheel speed, encoder ticks per second; clamped to the model's top speed. Throws
  /// std::out_of_range for a robot without encoders.
  void set_motor_speed(RobotIndex robot, unsigned motor, double ticks_per_second);
  /// The same in radians per second of the wheel.
  void set_wheel(RobotIndex robot, unsigned motor, double radians_per_second);
  /// Turns the front wheels of an Ackermann drive, radians, left is positive; clamped. So does the
  /// model's steering servo. Throws std::out_of_range for other drives.
  void set_steering(RobotIndex robot, double angle);
  /// Gains as the IO7 board takes them, 0 … 255 each (clamped); 4, 1, 1 by default.
  void set_motor_pid(RobotIndex robot, unsigned motor, int p, int i, int d);
  [[nodiscard]] std::int64_t encoder_ticks(RobotIndex robot, unsigned motor) const;
  void reset_encoder(RobotIndex robot, unsigned motor);

  // Sensors. A fresh reading of the present state at every call; errors draw from the device's
  // stream.
  [[nodiscard]] double read_range(RobotIndex robot, std::size_t sensor);
  /// read_range() of all range sensors, in the order of the model: the same readings, faster.
  /// `ranges` has room for as many as there are, else std::out_of_range.
  void read_ranges(RobotIndex robot, std::span<double> ranges);
  /// read_ranges() of all robots, those of the first one first: the same readings, in less time
  /// where there are many. Those of robots that were removed mean nothing, but need their room.
  /// Throws std::out_of_range unless there is room for exactly all.
  void read_all_ranges(std::span<double> ranges);
  /// What read_range() would give without the sensor's error. Draws nothing: asking for it does not
  /// change a run.
  [[nodiscard]] double true_range(RobotIndex robot, std::size_t sensor) const;
  /// How many other ultrasound sensors an ultrasound sensor may hear where robots stand now: those
  /// of its own robot whose cones overlap with its own, for they look at the same walls, and those
  /// of others that it looks at, nothing being between, and that look at it. 0 for other kinds.
  [[nodiscard]] unsigned cross_talkers(RobotIndex robot, std::size_t sensor) const;
  [[nodiscard]] bool read_proximity(RobotIndex robot, std::size_t sensor);
  [[nodiscard]] bool read_bumper(RobotIndex robot, std::size_t bumper);
  /// Ranges of a scan of `points` rays over `field_of_view` radians centred on the front, from the
  /// left-most ray clockwise to the right-most. A full circle starts straight behind and does not
  /// repeat its first ray. Ray i looks along bearing fov/2 - i * fov/points (full circle), or
  /// fov/2 - i * fov/(points - 1).
  /// Tilted as the model says. Walls and bodies count as high enough for every ray; a ray that is
  /// tilted down (positive) ends on the floor. A single ray looks ahead. Throws
  /// std::bad_optional_access when the robot has no lidar.
  void read_lidar(RobotIndex robot, double field_of_view, std::span<double> ranges);
  /// The same with another tilt, radians, -pi/2 … pi/2.
  void read_lidar(RobotIndex robot, double field_of_view, double tilt, std::span<double> ranges);
  /// Ranges of the zones of the model's range matrix number `matrix`, the top row first, each from
  /// the left. A range is that of the nearest thing in the zone's cone, measured along the axis of
  /// the sensor, which is what such sensors tell: all zones that see a wall straight ahead read the
  /// same. Walls and bodies count as high enough for every zone; zones that look down see the
  /// floor. Throws std::out_of_range without such a matrix, and unless `ranges` has a place for
  /// each zone.
  void read_range_matrix(RobotIndex robot, std::size_t matrix, std::span<double> ranges);
  /// Heading in the world, radians counter-clockwise from +x, with the model's error.
  [[nodiscard]] double read_compass(RobotIndex robot);

  /// Rate of turn, radians per second counter-clockwise, of the last step, with the model's error.
  /// Its bias strays with the time of the simulation, however often it is asked.
  [[nodiscard]] double read_gyroscope(RobotIndex robot);
  /// Acceleration of the robot's centre in its own frame (x forward, y left), metres per second
  /// squared, with the model's error: how its speed changed in the last step, and what holds it on
  /// its curve. The floor is level: gravity is not in it. A collision is one step long, and larger
  /// than a real device can say.
  [[nodiscard]] Vec2 read_accelerometer(RobotIndex robot);

  /// What the noise of the robot's camera is seeded with: of the run's seed, as the devices'
  /// streams are, and shared with none of them.
  [[nodiscard]] std::uint64_t camera_noise_seed(RobotIndex robot) const;

  /// Turns a servo at once. `position` 0 … 1, clamped without an error; 0.5 is the middle and the
  /// start. Servo 0 is pan (1 = left), 1 is tilt (1 = up); that of the model's kicker kicks, the
  /// steering one of an Ackermann drive steers (0 = left, as EyeSim's), one that turns a wheel does
  /// what set_motor_duty() does. Throws std::out_of_range unless `servo` < kServoCount.
  void set_servo(RobotIndex robot, unsigned servo, double position);
  /// Where a servo stands, 0 … 1. Throws as set_servo() does.
  [[nodiscard]] double servo(RobotIndex robot, unsigned servo) const;

  /// What ran into what, the oldest first: the last kCollisionsKept at least. Robots, obstacles and
  /// all things that move; lent until the next step.
  [[nodiscard]] std::span<const CollisionEvent> collisions() const;
  /// How many there have been since the start.
  [[nodiscard]] std::uint64_t collision_count() const;
  /// Called from step() once for each new contact. Replaces the previous listener.
  void on_collision(std::function<void(const CollisionEvent&)> listener);

  [[nodiscard]] const world::World& world() const;
  [[nodiscard]] world::World& world();
  [[nodiscard]] std::uint64_t state_hash() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::robot
