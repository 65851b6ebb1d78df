#include "eyebridge/pins/board_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "eyebridge/base/units.hpp"
#include "eyebridge/pins/psd_table.hpp"
#include "eyebridge/pins/robot_pins.hpp"

namespace eyebridge::pins {
namespace {

constexpr Time kScanPeriod = std::chrono::milliseconds(200);
constexpr Time kZonesPeriod = std::chrono::milliseconds(66);
constexpr Time kMostLate = std::chrono::milliseconds(500);

std::uint16_t in_mm(double range) {
  return static_cast<std::uint16_t>(std::clamp(std::lround(m_to_mm(range)), 0L, 9999L));
}

}  // namespace

struct BoardWorld::PlacedBoard {
  robot::RobotIndex robot = 0;
  eb_board board{};
  Time next_scan{};
  Time next_zones{};
  std::size_t next_matrix = 0;
};

struct BoardWorld::PlacedRover {
  robot::RobotIndex robot = 0;
  rv_rover rover{};
};

BoardWorld::BoardWorld(const files::Scenario& scenario, const robot::SimulationSettings& settings)
    : simulation_(std::make_shared<const world::WorldModel>(scenario.world), settings),
      step_(from_seconds(settings.step)) {
  for (const files::RobotPlacement& placement : scenario.robots) {
    robot::RobotModel model = scenario.models.at(placement.model);
    // A board drives a left and a right wheel, whatever robot it is put on.
    model.drive.kind = robot::DriveKind::Differential;
    simulation_.add_robot(model, placement.pose);
  }
}
BoardWorld::~BoardWorld() = default;

std::size_t BoardWorld::robots() const { return simulation_.robot_count(); }

eb_board& BoardWorld::add_board(robot::RobotIndex index, const eb_config& config) {
  if (index >= robots()) throw std::out_of_range("no such robot");
  const auto old =
      std::ranges::find(boards_, index, [](const auto& placed) { return placed->robot; });
  PlacedBoard& placed =
      old != boards_.end() ? **old : *boards_.emplace_back(std::make_unique<PlacedBoard>());
  placed.robot = index;
  eb_config complete = config;
  complete.drive = drive_config(simulation_.model(index).drive, config.drive.stall_timeout_us);
  complete.psd_mm = psd_table().data();
  complete.lidar = simulation_.model(index).lidar.has_value();
  complete.matrices = 0;
  for (const robot::RangeMatrixModel& matrix : simulation_.model(index).range_matrices) {
    complete.matrices |= static_cast<std::uint8_t>(1U << (matrix.id - 1));
  }
  read_pins(simulation_, placed.robot, placed.board.pins);
  const eb_pins pins = placed.board.pins;
  eb_board_init(&placed.board, &complete, &pins);
  return placed.board;
}

rv_rover& BoardWorld::add_rover(robot::RobotIndex index) {
  if (index >= robots()) throw std::out_of_range("no such robot");
  PlacedRover& placed = *rovers_.emplace_back(std::make_unique<PlacedRover>());
  placed.robot = index;
  const robot::DriveModel& drive = simulation_.model(index).drive;
  rv_config config{};
  config.ticks_per_turn = static_cast<std::uint32_t>(std::lround(drive.ticks_per_revolution));
  config.full_ticks = drive_config(drive, 0).full_ticks;
  config.psd_mm = psd_table().data();
  eb_pins pins{};
  read_pins(simulation_, index, pins);
  rv_rover_init(&placed.rover, &config, &pins);
  return placed.rover;
}

void BoardWorld::offer_scan(PlacedBoard& placed) {
  const auto& lidar = simulation_.model(placed.robot).lidar;
  if (!lidar || placed.board.node.id == 0 || from_seconds(simulation_.time()) < placed.next_scan)
    return;
  placed.next_scan = from_seconds(simulation_.time()) + kScanPeriod;
  eb_scan scan{};
  scan.points = static_cast<std::uint16_t>(std::clamp(lidar->points, 1, EB_LIDAR_POINTS));
  scan.range_deg = static_cast<std::uint16_t>(
      std::clamp(std::lround(rad_to_deg(lidar->field_of_view)), 1L, 360L));
  scan.tilt_deg =
      static_cast<std::int8_t>(std::clamp(std::lround(rad_to_deg(lidar->tilt)), -90L, 90L));
  std::vector<double> ranges(scan.points);
  simulation_.read_lidar(placed.robot, lidar->field_of_view, ranges);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    scan.range_mm[i] = in_mm(ranges[i]);
  }
  eb_board_lidar(&placed.board, &scan);
}

void BoardWorld::offer_zones(PlacedBoard& placed) {
  const auto& matrices = simulation_.model(placed.robot).range_matrices;
  const Time now = from_seconds(simulation_.time());
  if (matrices.empty() || placed.board.node.id == 0 || now < placed.next_zones) return;
  placed.next_zones = now + kZonesPeriod / static_cast<int>(matrices.size());
  const std::size_t index = placed.next_matrix++ % matrices.size();
  std::array<double, EB_ZONES> ranges{};
  simulation_.read_range_matrix(placed.robot, index, ranges);
  std::array<std::uint16_t, EB_ZONES> range_mm{};
  std::ranges::transform(ranges, range_mm.begin(), in_mm);
  eb_board_zones(&placed.board, matrices[index].id, range_mm.data());
}

void BoardWorld::step() {
  const auto elapsed = std::chrono::duration_cast<std::chrono::microseconds>(step_);
  for (const auto& placed : boards_) {
    read_pins(simulation_, placed->robot, placed->board.pins);
    offer_scan(*placed);
    offer_zones(*placed);
    eb_board_process(&placed->board, static_cast<std::uint32_t>(elapsed.count()));
    obey_pins(placed->board.pins, simulation_, placed->robot);
  }
  for (const auto& placed : rovers_) {
    read_pins(simulation_, placed->robot, placed->rover.pins);
    rv_rover_process(&placed->rover, static_cast<std::uint32_t>(elapsed.count()));
    obey_pins(placed->rover.pins, simulation_, placed->robot);
  }
  simulation_.step();
}

Time BoardWorld::advance(Time now) {
  if (now - due_ > kMostLate) due_ = now - kMostLate;
  for (; due_ <= now; due_ += step_) step();
  return due_;
}

}  // namespace eyebridge::pins
