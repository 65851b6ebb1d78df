#pragma once

#include <array>
#include <limits>

#include "cruise.hpp"
#include "eyebridge/robot/simulation.hpp"
#include "robot_state.hpp"

namespace eyebridge::robot {

/// Whether `servo`, turned from `before` to `after`, lets the kicker strike.
bool strikes(const KickerModel& kicker, unsigned servo, double before, double after);

struct Simulation::Impl {
  Impl(std::shared_ptr<const world::WorldModel> model, const SimulationSettings& given);

  // All four throw std::out_of_range.
  [[nodiscard]] world::BodyId body_of(RobotIndex robot) const { return cruises.at(robot).body; }
  /// Up to date.
  [[nodiscard]] RobotState& at(RobotIndex robot) {
    RobotState& state = states.at(robot);
    if (cruises[robot].steps != 0) catch_up(robot);
    return state;
  }
  /// at(), to change something: what the robot did so far need not go on.
  [[nodiscard]] RobotState& command(RobotIndex robot) {
    RobotState& state = at(robot);
    state.plan.repeats = false;
    cruises[robot].mode = Cruise::Mode::Off;
    asked[robot] = kNothing;
    return state;
  }
  [[nodiscard]] RobotDevices& devices_of(RobotIndex robot) { return devices.at(robot); }
  /// How far a device on `robot` sees, metres; `reach` when nothing is nearer.
  [[nodiscard]] double look(RobotIndex robot, const Sight& device, double reach) const;
  /// How far away a range sensor takes things to be, metres, by its kind and without its error;
  /// at its reach, or beyond, when it notices none.
  [[nodiscard]] double measure(RobotIndex robot, std::size_t sensor);
  /// How far the ray of a range sensor goes, metres; at its reach, or beyond, when it meets
  /// nothing.
  [[nodiscard]] double ray_range(RobotIndex robot, std::size_t sensor);
  /// Keeps how far the rays of those range sensors go that have a bit here.
  void measure_rays(RobotIndex robot, std::uint64_t sensors);
  /// What a fan is lent.
  struct Looks {
    std::array<Vec2, RangeLayout::kMostInFan> directions;
    std::array<Vec2, RangeLayout::kMostInFan> origins;
  };
  /// The rays of the sensors which(0), which(1), … of `fan`, without their ranges.
  template <class Which>
  [[nodiscard]] world::RayFan fan_of(const Eyes& its, const RangeLayout::Fan& fan,
                                     std::size_t count, Which which, Looks& lent) const;
  /// Adds the rays of `robot`, whose range sensors are all rays, to `fans`, where there are none or
  /// room for all of its among world::kFansTogether; they will be `ranges` long.
  void add_fans(RobotIndex robot, std::span<double> ranges);
  /// What its sensors make of `ranges`.
  void finish_ranges(RobotIndex robot, std::span<double> ranges);
  /// The nearest surface in the cone of an ultrasound sensor that sends its sound back.
  [[nodiscard]] double first_echo(RobotIndex robot, std::size_t sensor);
  /// Whether an ultrasound sensor of `robot` and one of another robot look at each other.
  [[nodiscard]] bool see_each_other(RobotIndex robot, std::size_t sensor, RobotIndex other,
                                    std::size_t others_sensor) const;
  /// Lets the bias of a gyroscope stray by what has passed since the last time.
  void stray_gyroscope(RobotIndex robot);
  /// One step of one robot: from command to pose.
  void step_robot(RobotIndex robot);
  /// The steps that a Cruise only counted.
  void catch_up(RobotIndex robot);
  /// All stages of a step that no Cruise did; `met` is what the body met, if it has moved already.
  template <class Drive>
  void run_pipeline(Cruise& cruise, RobotState& state, Drive& chassis,
                    const world::MoveResult* met);
  /// What the controller makes of a step that odometry saw, and that something `stalls`, or not.
  template <class Drive>
  void tell_controller(RobotState& state, Drive& chassis, const BodyStep& seen, bool stalls);
  /// Kicks the ball that is nearest to the kicker, if one is in its reach.
  void strike(RobotIndex robot, const KickerModel& kicker);
  /// Tells of the contacts that began in the step that has just ended.
  void report_collisions();
  [[nodiscard]] std::optional<RobotIndex> robot_of(world::BodyId body) const;

  SimulationSettings settings;
  world::World world;
  std::uint64_t steps = 0;
  std::uint32_t stall_timeout_steps;
  /// No speed that anyone asks for.
  static constexpr Twist kNothing{std::numeric_limits<double>::quiet_NaN(), 0.0};

  std::vector<RobotState> states;
  std::vector<Cruise> cruises;
  std::vector<Twist> asked;  ///< By set_speed(), while the robot goes steadily by it; or kNothing.
  std::vector<Eyes> eyes;
  std::vector<RobotDevices> devices;
  std::function<void(const CollisionEvent&)> listener;
  std::vector<CollisionEvent> collisions;
  std::uint64_t collisions_dropped = 0;
  ScanShapes scans;
  // Of the reading at hand; kept for its memory.
  std::vector<world::RayFan> fans;
  std::vector<Looks> looks;  ///< What `fans` are lent.
  std::vector<Vec2> cone_directions;
  std::vector<Vec2> scan_directions;
  std::vector<double> cone_ranges;
  std::vector<Vec2> contacts;  // of the reading at hand; kept for its memory
};

}  // namespace eyebridge::robot
