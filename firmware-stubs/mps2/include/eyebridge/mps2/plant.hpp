#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "eb_config.h"
#include "eyebridge/mps2/plant_frame.hpp"
#include "eyebridge/pins/board_world.hpp"

namespace eyebridge::mps2 {

/// The plant's side of the plant link: a robot of a simulated world, driven by a firmware that is
/// reached by bytes only. The firmware's time is the world's: each of its periods is one exchange,
/// by which the world goes on, so that neither sees the other late. Pure: no clock, no I/O.
class Plant {
 public:
  /// `world` outlives it. `config` is the dialect and the silence that the firmware is told; the
  /// drive is that of the robot. Throws std::out_of_range when there is no such robot.
  Plant(pins::BoardWorld& world, robot::RobotIndex robot, const eb_config& config);

  /// Takes what the firmware sent; returns what it gets. Frames that are broken, repeated or out of
  /// order do not move the world.
  std::vector<std::uint8_t> receive(std::span<const std::uint8_t> bytes);

  /// The board's host went away; the firmware is told with the next inputs.
  void host_lost() { ++losses_; }
  /// The firmware knows of every loss: what comes from its host line is for the present host.
  [[nodiscard]] bool settled() const { return losses_ == losses_known_; }

  [[nodiscard]] std::uint64_t periods() const { return periods_; }  ///< Exchanges so far.
  /// How often a firmware began; more than one: it has restarted, its motors off.
  [[nodiscard]] int starts() const { return starts_; }
  /// Why this firmware cannot be served; "" as long as it can.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  /// Bytes that belonged to no frame.
  [[nodiscard]] std::uint32_t dropped() const { return parser_.dropped(); }

 private:
  void begin(std::uint8_t format, std::vector<std::uint8_t>& reply);
  void exchange(std::uint8_t sequence, const PlantOutputs& outputs,
                std::vector<std::uint8_t>& reply);

  pins::BoardWorld& world_;
  robot::RobotIndex robot_;
  eb_config config_;
  eb_pins pins_{};
  PlantParser parser_;
  std::uint8_t sequence_ = 0;           // of the inputs that went out last
  std::vector<std::uint8_t> answered_;  // their bytes
  double elapsed_ = 0;                  // of the firmware's time, not stepped yet; seconds
  std::uint8_t losses_ = 0, losses_known_ = 0;
  std::uint64_t periods_ = 0;
  int starts_ = 0;
  bool begun_ = false, moved_ = false;
  std::string refusal_;
};

}  // namespace eyebridge::mps2
