#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "eb_board.h"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/files/scenario.hpp"
#include "eyebridge/robot/simulation.hpp"
#include "rv_rover.h"

namespace eyebridge::pins {

/// A simulated world in which boards drive the robots: their duty turns its motors, and what its
/// wheels and sensors do arrives at their pins. One thread.
///
/// Motors and encoders 1 and 2 are the left and right wheel. PSD n is the range sensor with number
/// n. Bumpers, then proximity switches, drive digital ports 0, 1, …: 1 is touched or near. Servos
/// 1 and 2 turn from 1.0 to 2.0 ms. The battery has 7.40 V. A lidar is scanned five times a second,
/// range matrices are read fifteen times.
class BoardWorld {
 public:
  /// Robots as `scenario` places them. Throws std::invalid_argument as Simulation does.
  explicit BoardWorld(const files::Scenario& scenario,
                      const robot::SimulationSettings& settings = {});
  ~BoardWorld();

  [[nodiscard]] std::size_t robots() const;
  /// Gives robot `index` a board that speaks as `config` says; what `config.drive`, the PSD
  /// table, `config.lidar` and `config.matrices` are is set here. A robot that had one gets a new
  /// one. The board lives as long as the world. Throws std::out_of_range when there is no such
  /// robot.
  eb_board& add_board(robot::RobotIndex index, const eb_config& config);

  /// Gives robot `index` the electronics of a rover. They live as long as the world. Throws
  /// std::out_of_range when there is no such robot.
  rv_rover& add_rover(robot::RobotIndex index);

  /// One step of the world: every board sees its pins, works, and moves its robot.
  void step();
  /// Steps until the world has caught up with `now`, which began at 0 with the world; what is more
  /// than half a second late is left out. Returns when the next step is due.
  Time advance(Time now);

  [[nodiscard]] robot::Simulation& simulation() { return simulation_; }

 private:
  struct PlacedBoard;  // a robot and its board
  struct PlacedRover;  // a robot and its rover
  void offer_scan(PlacedBoard& placed);
  void offer_zones(PlacedBoard& placed);

  robot::Simulation simulation_;
  std::vector<std::unique_ptr<PlacedBoard>> boards_;
  std::vector<std::unique_ptr<PlacedRover>> rovers_;
  Time step_;
  Time due_{};
};

}  // namespace eyebridge::pins
