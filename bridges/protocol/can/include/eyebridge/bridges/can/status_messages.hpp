#pragma once

#include <array>
#include <cstdint>

#include "opcodes.h"

// What robots say to the host. Numbers are as on the wire, in the unit that the name ends in (cdeg
// is 0.01 degree, ddeg 0.1 degree, cv 0.01 V, ds 0.1 s). visit() lists the fields in the order of
// the table.
namespace eyebridge::bridges::can {

/// What is wrong with a robot; code 0 when it is over.
struct FaultStatus {
  static constexpr int kFunction = EYECAN_S_FAULT;
  static constexpr bool kFd = false;

  std::uint16_t code = EYECAN_FAULT_NONE;  ///< EYECAN_FAULT_…
  std::uint8_t error_register = 0;         ///< Bits: EYECAN_REGISTER_…
  std::uint16_t flags = 0;                 ///< Bits: EYECAN_FLAG_…, all steady faults.
  std::uint32_t aux = 0;                   ///< 24 bits; depends on `code`.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.code, self.error_register, self.flags, self.aux);
  }
  friend bool operator==(const FaultStatus&, const FaultStatus&) = default;
};

/// Odometry.
struct PoseStatus {
  static constexpr int kFunction = EYECAN_S_POSE;
  static constexpr bool kFd = false;

  std::int32_t x_mm = 0;      ///< 24 bits.
  std::int32_t y_mm = 0;      ///< 24 bits.
  std::int16_t phi_cdeg = 0;  ///< Counter-clockwise.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.x_mm, self.y_mm, self.phi_cdeg);
  }
  friend bool operator==(const PoseStatus&, const PoseStatus&) = default;
};

/// Measured speed, and how far the move is.
struct SpeedStatus {
  static constexpr int kFunction = EYECAN_S_SPEED;
  static constexpr bool kFd = false;

  std::int16_t v_mm_s = 0;
  std::int16_t w_cdeg_s = 0;
  std::uint8_t move_state = EYECAN_MOVE_IDLE;  ///< EYECAN_MOVE_…
  bool stall_left = false;
  bool stall_right = false;
  bool motors_enabled = false;
  bool command_timeout = false;
  std::uint8_t last_move_seq = 0;  ///< Of the move that was taken last.
  std::int16_t remaining_mm = 0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.v_mm_s, self.w_cdeg_s, self.move_state, self.stall_left, self.stall_right,
            self.motors_enabled, self.command_timeout, self.last_move_seq, self.remaining_mm);
  }
  friend bool operator==(const SpeedStatus&, const SpeedStatus&) = default;
};

/// Ticks of encoders 1 and 2.
struct Encoder12Status {
  static constexpr int kFunction = EYECAN_S_ENC12;
  static constexpr bool kFd = false;

  std::array<std::int32_t, 2> ticks{};

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.ticks);
  }
  friend bool operator==(const Encoder12Status&, const Encoder12Status&) = default;
};

/// Ticks of encoders 3 and 4.
struct Encoder34Status {
  static constexpr int kFunction = EYECAN_S_ENC34;
  static constexpr bool kFd = false;

  std::array<std::int32_t, 2> ticks{};

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.ticks);
  }
  friend bool operator==(const Encoder34Status&, const Encoder34Status&) = default;
};

/// Ranges of PSD 1 … 4.
struct PsdAStatus {
  static constexpr int kFunction = EYECAN_S_PSD_A;
  static constexpr bool kFd = false;

  std::array<std::uint16_t, 4> range_mm{};  ///< 9999: out of range; EYECAN_ABSENT: no such sensor.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.range_mm);
  }
  friend bool operator==(const PsdAStatus&, const PsdAStatus&) = default;
};

/// Ranges and ADC values of PSD 5 and 6.
struct PsdBStatus {
  static constexpr int kFunction = EYECAN_S_PSD_B;
  static constexpr bool kFd = false;

  std::array<std::uint16_t, 2> range_mm{};
  std::array<std::uint16_t, 2> raw{};  ///< 0 … 4095 or EYECAN_ABSENT.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.range_mm, self.raw);
  }
  friend bool operator==(const PsdBStatus&, const PsdBStatus&) = default;
};

/// ADC values of PSD 1 … 4.
struct PsdRawStatus {
  static constexpr int kFunction = EYECAN_S_PSD_RAW;
  static constexpr bool kFd = false;

  std::array<std::uint16_t, 4> raw{};  ///< 0 … 4095 or EYECAN_ABSENT.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.raw);
  }
  friend bool operator==(const PsdRawStatus&, const PsdRawStatus&) = default;
};

/// The digital ports; bit n is port n.
struct DigitalStatus {
  static constexpr int kFunction = EYECAN_S_DIGITAL;
  static constexpr bool kFd = false;

  std::uint16_t in = 0;
  std::uint16_t out = 0;
  std::uint16_t outputs = 0;  ///< Which ports are outputs.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.in, self.out, self.outputs);
  }
  friend bool operator==(const DigitalStatus&, const DigitalStatus&) = default;
};

/// Analog channels 0 … 3.
struct AnalogAStatus {
  static constexpr int kFunction = EYECAN_S_ANALOG_A;
  static constexpr bool kFd = false;

  std::array<std::uint16_t, 4> raw{};  ///< 0 … 4095 or EYECAN_ABSENT.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.raw);
  }
  friend bool operator==(const AnalogAStatus&, const AnalogAStatus&) = default;
};

/// Analog channels 4 … 7.
struct AnalogBStatus {
  static constexpr int kFunction = EYECAN_S_ANALOG_B;
  static constexpr bool kFd = false;

  std::array<std::uint16_t, 4> raw{};  ///< 0 … 4095 or EYECAN_ABSENT.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.raw);
  }
  friend bool operator==(const AnalogBStatus&, const AnalogBStatus&) = default;
};

/// Supply, microphone, remote control, time since start.
struct BoardStatus {
  static constexpr int kFunction = EYECAN_S_STATUS;
  static constexpr bool kFd = false;

  std::uint16_t battery_cv = 0;  ///< EYECAN_ABSENT: not measured.
  std::uint16_t microphone = 0;  ///< 0 … 4095 or EYECAN_ABSENT.
  std::uint8_t ir_key = 0;       ///< 0: none.
  std::uint32_t uptime_ds = 0;   ///< 24 bits; going back is a restart.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.battery_cv, self.microphone, self.ir_key, self.uptime_ds);
  }
  friend bool operator==(const BoardStatus&, const BoardStatus&) = default;
};

/// Comes before the points of a scan.
struct LidarHeader {
  static constexpr int kFunction = EYECAN_S_LIDAR_HDR;
  static constexpr bool kFd = false;

  std::uint8_t scan_id = 0;
  std::uint16_t points = 1;
  std::uint16_t range_deg = 360;  ///< Field of view, centred on the front.
  std::int8_t tilt_deg = 0;       ///< Downwards.
  std::uint16_t time_ms = 0;      ///< Of the robot's clock, wrapping.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.scan_id, self.points, self.range_deg, self.tilt_deg, self.time_ms);
  }
  friend bool operator==(const LidarHeader&, const LidarHeader&) = default;
};

/// Three points of a scan.
struct LidarChunk {
  static constexpr int kFunction = EYECAN_S_LIDAR_CHUNK;
  static constexpr bool kFd = false;

  std::uint8_t scan_id_low = 0;             ///< Lowest 4 bits.
  std::uint16_t chunk = 0;                  ///< Index of the first point / 3; 12 bits.
  std::array<std::uint16_t, 3> range_mm{};  ///< 9999: out of range; EYECAN_ABSENT: no such point.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.scan_id_low, self.chunk, self.range_mm);
  }
  friend bool operator==(const LidarChunk&, const LidarChunk&) = default;
};

/// Up to thirty points of a scan, in a CAN FD frame.
struct LidarChunkFd {
  static constexpr int kFunction = EYECAN_S_LIDAR_CHUNK;
  static constexpr bool kFd = true;

  std::uint8_t scan_id = 0;
  std::uint8_t count = 1;                    ///< Points in use.
  std::uint16_t first = 0;                   ///< Index of the first point.
  std::array<std::uint16_t, 30> range_mm{};  ///< 9999: out of range; EYECAN_ABSENT: no such point.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.scan_id, self.count, self.first, self.range_mm);
  }
  friend bool operator==(const LidarChunkFd&, const LidarChunkFd&) = default;
};

/// Three zones of a range matrix.
struct ZoneChunk {
  static constexpr int kFunction = EYECAN_S_ZONES;
  static constexpr bool kFd = false;

  std::uint8_t matrix = 1;
  std::uint8_t reading = 0;                 ///< Lowest 4 bits of a count.
  std::uint8_t chunk = 0;                   ///< Index of the first zone / 3.
  std::array<std::uint16_t, 3> range_mm{};  ///< 9999: out of range; EYECAN_ABSENT: not measured.

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.matrix, self.reading, self.chunk, self.range_mm);
  }
  friend bool operator==(const ZoneChunk&, const ZoneChunk&) = default;
};

/// Who a robot is.
struct VersionStatus {
  static constexpr int kFunction = EYECAN_S_VERSION;
  static constexpr bool kFd = false;

  std::uint8_t protocol = EYECAN_PROTOCOL_VERSION;
  std::array<char, 4> firmware{'0', '0', '0', '0'};  ///< Printable.
  std::uint8_t hardware = EYECAN_HARDWARE_UNKNOWN;   ///< EYECAN_HARDWARE_…
  std::uint16_t capabilities = 0;                    ///< Bits: EYECAN_CAPABLE_OF_….

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.protocol, self.firmware, self.hardware, self.capabilities);
  }
  friend bool operator==(const VersionStatus&, const VersionStatus&) = default;
};

/// Sent by every robot and by the host (node 15) every 100 ms.
struct Heartbeat {
  static constexpr int kFunction = EYECAN_HEARTBEAT;
  static constexpr bool kFd = false;

  std::uint8_t state = EYECAN_STATE_BOOT;  ///< EYECAN_STATE_…

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(self.state);
  }
  friend bool operator==(const Heartbeat&, const Heartbeat&) = default;
};

}  // namespace eyebridge::bridges::can
