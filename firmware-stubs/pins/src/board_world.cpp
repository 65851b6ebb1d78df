#include "eyebridge/pins/board_world.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "eyebridge/base/units.hpp"
#include "eyebridge/pins/psd_table.hpp"

namespace eyebridge::pins {
namespace {

constexpr std::uint16_t kBatteryCv = 740;
constexpr double kVoltsAtTopAdc = 20.0;  // analog 0
constexpr std::uint16_t kQuiet = 2048;   // the microphone
constexpr Time kScanPeriod = std::chrono::milliseconds(200);
constexpr Time kMostLate = std::chrono::milliseconds(500);
constexpr unsigned kWheels = 2;
constexpr double kShortestPulse = 1000;  // microseconds
constexpr double kPulseRange = 1000;

}  // namespace

struct BoardWorld::Seat {
  robot::RobotIndex robot = 0;
  eb_board board{};
  Time next_scan{};
};

eb_drive_config drive_config(const robot::DriveModel& model) {
  const double ticks_per_metre = model.ticks_per_revolution / (kPi * model.wheel_diameter);
  eb_config config;
  eb_config_default(&config);
  eb_drive_config drive = config.drive;
  drive.ticks_per_metre = static_cast<float>(ticks_per_metre);
  drive.wheel_base = static_cast<float>(model.wheel_base);
  drive.max_linear = static_cast<float>(model.max_linear);
  drive.max_angular = static_cast<float>(model.max_angular);
  drive.linear_acceleration = static_cast<float>(model.linear_acceleration);
  drive.angular_acceleration = static_cast<float>(model.angular_acceleration);
  drive.motor_lag = static_cast<float>(model.motor_time_constant);
  drive.full_ticks =
      static_cast<float>(model.max_wheel_speed / (2 * kPi) * model.ticks_per_revolution * 0.01);
  return drive;
}

BoardWorld::BoardWorld(const files::Scenario& scenario, const robot::SimulationSettings& settings)
    : simulation_(std::make_shared<const world::WorldModel>(scenario.world), settings),
      step_(from_seconds(settings.step)) {
  for (const files::RobotPlacement& placement : scenario.robots) {
    simulation_.add_robot(scenario.models.at(placement.model), placement.pose);
  }
}
BoardWorld::~BoardWorld() = default;

std::size_t BoardWorld::robots() const { return simulation_.robot_count(); }

eb_board& BoardWorld::add_board(robot::RobotIndex index, const eb_config& config) {
  if (index >= robots()) throw std::out_of_range("no such robot");
  const auto old = std::ranges::find(seats_, index, [](const auto& seat) { return seat->robot; });
  Seat& seat = old != seats_.end() ? **old : *seats_.emplace_back(std::make_unique<Seat>());
  seat.robot = index;
  eb_config complete = config;
  complete.drive = drive_config(simulation_.model(index).drive);
  complete.drive.stall_timeout_us = config.drive.stall_timeout_us;
  complete.psd_mm = psd_table().data();
  complete.lidar = simulation_.model(index).lidar.has_value();
  read_pins(seat);
  const eb_pins pins = seat.board.pins;
  eb_board_init(&seat.board, &complete, &pins);
  return seat.board;
}

void BoardWorld::read_pins(Seat& seat) {
  const robot::RobotModel& model = simulation_.model(seat.robot);
  eb_pins& pins = seat.board.pins;
  for (unsigned wheel = 0; wheel < kWheels; ++wheel) {
    // The counters wrap: only the low bits are there.
    pins.encoder[wheel] =
        static_cast<std::uint16_t>(simulation_.encoder_ticks(seat.robot, wheel) & 0xFFFF);
  }
  std::ranges::fill(pins.psd, static_cast<std::uint16_t>(EB_PSD_ABSENT));
  for (std::size_t i = 0; i < model.range_sensors.size(); ++i) {
    const int id = model.range_sensors[i].id;
    if (id < 1 || id > EB_PSDS) continue;
    const double range = simulation_.read_range(seat.robot, i);
    const bool reached = range < model.range_sensors[i].out_of_range;
    pins.psd[id - 1] = reached ? psd_raw(range) : std::uint16_t{0};
  }
  unsigned port = 0;
  std::uint16_t levels = 0;
  const auto connect = [&](bool level) {
    if (port < EB_PORTS) levels = static_cast<std::uint16_t>(levels | (level ? 1U << port : 0U));
    ++port;
  };
  for (std::size_t i = 0; i < model.bumpers.size(); ++i) {
    connect(simulation_.read_bumper(seat.robot, i));
  }
  for (std::size_t i = 0; i < model.proximity_sensors.size(); ++i) {
    connect(simulation_.read_proximity(seat.robot, i));
  }
  pins.digital_in = levels;
  pins.digital_driven = static_cast<std::uint16_t>((1U << std::min<unsigned>(port, EB_PORTS)) - 1U);
  pins.supply_cv = kBatteryCv;
  pins.analog[0] = static_cast<std::uint16_t>(kBatteryCv / 100.0 / kVoltsAtTopAdc * 4095);
  pins.analog[8] = kQuiet;
}

void BoardWorld::offer_scan(Seat& seat) {
  const auto& lidar = simulation_.model(seat.robot).lidar;
  if (!lidar || seat.board.node.id == 0 || from_seconds(simulation_.time()) < seat.next_scan)
    return;
  seat.next_scan = from_seconds(simulation_.time()) + kScanPeriod;
  eb_scan scan{};
  scan.points = static_cast<std::uint16_t>(std::clamp(lidar->points, 1, EB_LIDAR_POINTS));
  scan.range_deg = static_cast<std::uint16_t>(
      std::clamp(std::lround(rad_to_deg(lidar->field_of_view)), 1L, 360L));
  scan.tilt_deg =
      static_cast<std::int8_t>(std::clamp(std::lround(rad_to_deg(lidar->tilt)), -90L, 90L));
  std::vector<double> ranges(scan.points);
  simulation_.read_lidar(seat.robot, lidar->field_of_view, ranges);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    scan.range_mm[i] =
        static_cast<std::uint16_t>(std::clamp(std::lround(m_to_mm(ranges[i])), 0L, 9999L));
  }
  eb_board_lidar(&seat.board, &scan);
}

void BoardWorld::obey_pins(const Seat& seat) {
  const eb_pins& pins = seat.board.pins;
  for (unsigned wheel = 0; wheel < kWheels; ++wheel) {
    simulation_.set_motor_duty(seat.robot, wheel,
                               static_cast<double>(pins.duty[wheel]) / EB_DUTY_FULL);
  }
  for (unsigned servo = 0; servo < EB_SERVOS; ++servo) {
    if (pins.servo_us[servo] == 0) continue;
    simulation_.set_servo(seat.robot, servo, (pins.servo_us[servo] - kShortestPulse) / kPulseRange);
  }
}

void BoardWorld::step() {
  const auto elapsed = std::chrono::duration_cast<std::chrono::microseconds>(step_);
  for (const auto& seat : seats_) {
    read_pins(*seat);
    offer_scan(*seat);
    eb_board_process(&seat->board, static_cast<std::uint32_t>(elapsed.count()));
    obey_pins(*seat);
  }
  simulation_.step();
}

Time BoardWorld::advance(Time now) {
  if (now - due_ > kMostLate) due_ = now - kMostLate;
  for (; due_ <= now; due_ += step_) step();
  return due_;
}

}  // namespace eyebridge::pins
