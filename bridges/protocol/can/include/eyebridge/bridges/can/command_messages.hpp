#pragma once

#include <array>
#include <cstdint>

#include "opcodes.h"

// What the host says to robots. Numbers are as on the wire, in the unit that the name ends in (cdeg
// is 0.01 degree, ddeg 0.1 degree, cv 0.01 V, ds 0.1 s). visit() lists the fields in the order of
// the table.
namespace eyebridge::bridges::can {

/// Switches a robot on and off. Sent to node 0; `node` says who is meant.
struct NmtCommand {
  static constexpr int kFunction = EYECAN_C_NMT;
  static constexpr bool kFd = false;

  std::uint8_t command = EYECAN_NMT_STOP;  ///< EYECAN_NMT_…
  std::uint8_t node = 0;                   ///< 0: all robots.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.command, self.node);
  }
  friend bool operator==(const NmtCommand&, const NmtCommand&) = default;
};

/// Stops now. To one robot, or as node 0 to all. Not a safety circuit.
struct EmergencyStop {
  static constexpr int kFunction = EYECAN_C_ESTOP;
  static constexpr bool kFd = false;

  std::uint8_t reason = EYECAN_ESTOP_USER;  ///< EYECAN_ESTOP_…
  std::uint8_t seq = 0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.reason, self.seq);
  }
  friend bool operator==(const EmergencyStop&, const EmergencyStop&) = default;
};

/// Drive at this speed until the next command; must be repeated.
struct SpeedCommand {
  static constexpr int kFunction = EYECAN_C_VW_SPEED;
  static constexpr bool kFd = false;

  std::int16_t v_mm_s = 0;
  std::int16_t w_cdeg_s = 0;  ///< Counter-clockwise.
  std::uint8_t seq = 0;
  std::uint8_t flags = 0;  ///< 0 in protocol version 1.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.v_mm_s, self.w_cdeg_s, self.seq, self.flags);
  }
  friend bool operator==(const SpeedCommand&, const SpeedCommand&) = default;
};

/// A movement that ends by itself.
struct MoveCommand {
  static constexpr int kFunction = EYECAN_C_VW_MOVE;
  static constexpr bool kFd = false;

  std::uint8_t type = EYECAN_VW_STRAIGHT;  ///< EYECAN_VW_…
  std::uint8_t seq = 0;                    ///< Echoed in SpeedStatus.
  std::int16_t distance_mm = 0;
  std::int16_t angle_ddeg = 0;  ///< Counter-clockwise.
  std::int16_t speed = 0;       ///< mm/s, for a turn deg/s; not negative.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.type, self.seq, self.distance_mm, self.angle_ddeg, self.speed);
  }
  friend bool operator==(const MoveCommand&, const MoveCommand&) = default;
};

/// Sets the robot's odometry.
struct PoseCommand {
  static constexpr int kFunction = EYECAN_C_SET_POSE;
  static constexpr bool kFd = false;

  std::int32_t x_mm = 0;  ///< 24 bits.
  std::int32_t y_mm = 0;  ///< 24 bits.
  std::int16_t phi_cdeg = 0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.x_mm, self.y_mm, self.phi_cdeg);
  }
  friend bool operator==(const PoseCommand&, const PoseCommand&) = default;
};

/// Drives motors one by one; must be repeated.
struct MotorCommand {
  static constexpr int kFunction = EYECAN_C_MOTOR;
  static constexpr bool kFd = false;

  std::array<std::int8_t, 4> value{};        ///< Percent or ticks per 10 ms, by `mode`.
  std::uint8_t mask = 0;                     ///< Bit n-1: motor n is meant.
  std::uint8_t mode = EYECAN_MOTOR_PERCENT;  ///< EYECAN_MOTOR_…
  std::uint8_t seq = 0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.value, self.mask, self.mode, self.seq);
  }
  friend bool operator==(const MotorCommand&, const MotorCommand&) = default;
};

/// Gains of a motor's speed controller.
struct PidCommand {
  static constexpr int kFunction = EYECAN_C_PID;
  static constexpr bool kFd = false;

  std::uint8_t motor = 1;  ///< 1 … 4
  std::uint8_t p = 0;
  std::uint8_t i = 0;
  std::uint8_t d = 0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.motor, self.p, self.i, self.d);
  }
  friend bool operator==(const PidCommand&, const PidCommand&) = default;
};

/// Positions of servos 1 … 7 (bank 0) or 8 … 14 (bank 1).
struct ServoCommand {
  static constexpr int kFunction = EYECAN_C_SERVO;
  static constexpr bool kFd = false;

  std::uint8_t bank = 0;
  std::array<std::uint8_t, 7> position{};  ///< 0 … 255 between the servo's limits.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.bank, self.position);
  }
  friend bool operator==(const ServoCommand&, const ServoCommand&) = default;
};

/// Sets outputs; bit n is port n.
struct DigitalCommand {
  static constexpr int kFunction = EYECAN_C_DIGITAL;
  static constexpr bool kFd = false;

  std::uint16_t mask = 0;  ///< Which ports are meant.
  std::uint16_t value = 0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.mask, self.value);
  }
  friend bool operator==(const DigitalCommand&, const DigitalCommand&) = default;
};

/// Makes a digital port an input or an output.
struct PortCommand {
  static constexpr int kFunction = EYECAN_C_DIGITAL_CFG;
  static constexpr bool kFd = false;

  std::uint8_t port = 0;                  ///< 0 … 15
  std::uint8_t mode = EYECAN_PORT_INPUT;  ///< EYECAN_PORT_…

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.port, self.mode);
  }
  friend bool operator==(const PortCommand&, const PortCommand&) = default;
};

}  // namespace eyebridge::bridges::can
