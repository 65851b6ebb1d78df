#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::files {

// The hardware description table (HDT) of an EyeBot: what is connected to which port of the board,
// and the tables that turn its raw numbers into ours. Facts: reference/io-hardware.md, part B.

/// `TABLE name` … `END TABLE`.
struct HdtTable {
  std::string name;
  std::vector<int> values;
  SourceLocation where;

  friend bool operator==(const HdtTable&, const HdtTable&) = default;
};

/// How a line names its device: by number (EyeBot 7, since 2015) or by quoted name (2013).
enum class HdtDialect { Numbered, Named };

/// What all devices have. In the named dialect the number counts the lines of a kind from 1.
struct HdtDevice {
  int id = 0;
  std::string name;                  ///< Empty in the numbered dialect.
  int address = 0;                   ///< Register, or constant of an ADC; named dialect only.
  std::optional<std::size_t> table;  ///< Index in Hdt::tables.
  SourceLocation where;

  friend bool operator==(const HdtDevice&, const HdtDevice&) = default;
};

struct HdtMotor : HdtDevice {
  int pwm_frequency = 0;  ///< Hertz; named dialect only.
};
struct HdtServo : HdtDevice {
  int frequency = 0;             ///< Hertz; named dialect only.
  double shortest_pulse = 1e-3;  ///< Of position 0, seconds …
  double longest_pulse = 2e-3;   ///< … and of position 255.
};
struct HdtEncoder : HdtDevice {
  double ticks_per_metre = 0.0;
  double max_speed = 0.0;  ///< As written; named dialect only, its unit is not documented.
  int motor = 0;           ///< Number of the motor that it sits on.
};
struct HdtPsd : HdtDevice {};

/// The wheels as the v-omega controller sees them.
struct HdtDrive {
  std::string name;
  robot::DriveKind kind = robot::DriveKind::Differential;
  double wheel_base = 0.0;          ///< Left to right, metres; of an Ackermann drive the front.
  double rear_wheel_base = 0.0;     ///< Ackermann drives only, metres.
  double axle_distance = 0.0;       ///< Front to rear, metres; Ackermann and Omni.
  double max_speed = 0.0;           ///< Metres per second; 0 in the named dialect: not said.
  bool left_clockwise = false;      ///< The motor turns clockwise where the other side's turns …
  bool right_clockwise = false;     ///< … counter-clockwise: mirrored motors differ in these.
  std::vector<int> encoders{1, 2};  ///< Their numbers, left before right, front before rear.
  SourceLocation where;
};

/// A camera; named dialect only.
struct HdtCamera : HdtDevice {
  int io = 0;
  int width = 0;   ///< Pixels.
  int height = 0;  ///< Pixels.
};

/// An infrared remote control, as its decoder wants it.
struct HdtRemote {
  std::string name;
  int type = 0;
  int length = 0;
  int toggle_mask = 0;
  int invert_mask = 0;
  int mode = 0;
  int buffer_size = 0;
  int delay = 0;
};

/// `USB number name` or `SERIAL "name" "device"`: a serial interface of SERInit().
struct HdtSerial {
  int id = 0;  ///< 0 is the serial port, 1 … 20 are USB devices.
  std::string name;
  std::string device;  ///< Named dialect only.
};

/// Everything an HDT file says. Wi-Fi passwords are checked and forgotten.
struct Hdt {
  HdtDialect dialect = HdtDialect::Numbered;
  std::string name;                    ///< Of the robot (EYEBOT); empty when not said.
  std::string network;                 ///< SSID; empty when not said.
  bool joins_network = false;          ///< Else it is a hotspot.
  std::optional<bool> starts_at_boot;  ///< ROBIOS
  std::optional<int> lcd_orientation;  ///< LCD: 0 or 1.
  std::optional<bool> remote_enabled;  ///< `IRTV 0|1`
  std::string demo_path;               ///< DEMOPATH
  std::string software_path;           ///< SOFTWAREPATH
  std::vector<HdtMotor> motors;        ///< By number, like all that follow.
  std::vector<HdtServo> servos;
  std::vector<HdtEncoder> encoders;
  std::vector<HdtPsd> psds;
  std::optional<HdtDrive> drive;
  std::optional<HdtCamera> camera;
  std::vector<HdtRemote> remotes;
  std::vector<HdtSerial> serials;
  std::vector<HdtDevice> adcs;
  std::vector<HdtTable> tables;  ///< In the order of the file.

  /// Table of `device`; null when it has none.
  [[nodiscard]] const HdtTable* table_of(const HdtDevice& device) const {
    return device.table ? &tables[*device.table] : nullptr;
  }
};

/// Reads an HDT in either dialect; a file that mixes them is refused. Words are separated by blanks
/// or commas, keywords in any case, `#` starts a comment anywhere outside quotes, tables may stand
/// anywhere. Keywords that are not known (COMPASS too: its fields are not documented) are ignored
/// with a warning. Throws ConfigError: for a device given twice, a table that is missing, given
/// twice, not closed or of the wrong length or range for what uses it, and for every bad number.
Hdt read_hdt(std::string_view text, const std::string& file, std::vector<Warning>& warnings);

/// Pulse widths for the board's `S` request, 10 us each: the HDT's, to the nearest, at most 255.
struct ServoLimits {
  int lower = 0;
  int upper = 0;
  friend bool operator==(const ServoLimits&, const ServoLimits&) = default;
};
ServoLimits servo_limits(const HdtServo& servo);

}  // namespace eyebridge::files
