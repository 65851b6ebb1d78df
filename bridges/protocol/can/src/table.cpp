#include "eyebridge/bridges/can/table.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace eyebridge::bridges::can {
namespace {

constexpr std::int64_t lowest(int length, bool is_signed) {
  return is_signed ? -(std::int64_t{1} << (length - 1)) : 0;
}
constexpr std::int64_t highest(int length, bool is_signed) {
  return (std::int64_t{1} << (is_signed ? length - 1 : length)) - 1;
}

/// Unsigned, signed: every raw value of that many bits is accepted.
constexpr Signal u(std::string_view name, int start, int length, std::string_view unit = "",
                   double scale = 1.0) {
  return {.name = name,
          .start = static_cast<std::uint16_t>(start),
          .length = static_cast<std::uint8_t>(length),
          .scale = scale,
          .unit = unit,
          .first = lowest(length, false),
          .last = highest(length, false)};
}
constexpr Signal s(std::string_view name, int start, int length, std::string_view unit = "",
                   double scale = 1.0) {
  Signal signal = u(name, start, length, unit, scale);
  signal.is_signed = true;
  signal.first = lowest(length, true);
  signal.last = highest(length, true);
  return signal;
}
constexpr Signal from(std::int64_t first, std::int64_t last, Signal signal) {
  signal.first = first;
  signal.last = last;
  return signal;
}
constexpr Signal absent(Signal signal) {
  signal.may_be_absent = true;
  return signal;
}
constexpr Signal in_bank(int bank, Signal signal) {
  signal.bank = bank;
  return signal;
}
constexpr Signal range_mm(std::string_view name, int start) {
  return absent(from(0, EYECAN_PSD_OUT_OF_RANGE, u(name, start, 16, "mm")));
}
constexpr Signal adc(std::string_view name, int start) {
  return absent(from(0, 4095, u(name, start, 16)));
}
constexpr Signal flag(std::string_view name, int start) { return u(name, start, 1); }
constexpr Signal character(std::string_view name, int start) {
  return from(0x20, 0x7E, u(name, start, 8));
}
constexpr Signal duty(std::string_view name, int start) { return s(name, start, 8); }

constexpr Signal kNmt[] = {u("Command", 0, 8), from(0, EYECAN_NODE_LAST, u("Node", 8, 8))};
constexpr Signal kEStop[] = {from(EYECAN_ESTOP_USER, EYECAN_ESTOP_HOST_FAULT, u("Reason", 0, 8)),
                             u("Seq", 8, 8)};
constexpr Signal kFault[] = {u("Code", 0, 16), u("Register", 16, 8), u("Flags", 24, 16),
                             u("Aux", 40, 24)};
constexpr Signal kPose[] = {s("X", 0, 24, "mm"), s("Y", 24, 24, "mm"),
                            s("Phi", 48, 16, "deg", 0.01)};
constexpr Signal kSpeed[] = {s("V", 0, 16, "mm/s"),
                             s("W", 16, 16, "deg/s", 0.01),
                             from(EYECAN_MOVE_IDLE, EYECAN_MOVE_ABORTED, u("MoveState", 32, 4)),
                             flag("StallLeft", 36),
                             flag("StallRight", 37),
                             flag("MotorsEnabled", 38),
                             flag("CommandTimeout", 39),
                             u("LastMoveSeq", 40, 8),
                             s("Remaining", 48, 16, "mm")};
constexpr Signal kEnc12[] = {s("Encoder1", 0, 32, "ticks"), s("Encoder2", 32, 32, "ticks")};
constexpr Signal kEnc34[] = {s("Encoder3", 0, 32, "ticks"), s("Encoder4", 32, 32, "ticks")};
constexpr Signal kPsdA[] = {range_mm("Psd1", 0), range_mm("Psd2", 16), range_mm("Psd3", 32),
                            range_mm("Psd4", 48)};
constexpr Signal kPsdB[] = {range_mm("Psd5", 0), range_mm("Psd6", 16), adc("Psd5Raw", 32),
                            adc("Psd6Raw", 48)};
constexpr Signal kPsdRaw[] = {adc("Psd1Raw", 0), adc("Psd2Raw", 16), adc("Psd3Raw", 32),
                              adc("Psd4Raw", 48)};
constexpr Signal kDigital[] = {u("In", 0, 16), u("Out", 16, 16), u("Outputs", 32, 16)};
constexpr Signal kVwSpeed[] = {s("V", 0, 16, "mm/s"), s("W", 16, 16, "deg/s", 0.01),
                               u("Seq", 32, 8), u("Flags", 40, 8)};
constexpr Signal kVwMove[] = {from(EYECAN_VW_STRAIGHT, EYECAN_VW_DRIVE, u("Type", 0, 8)),
                              u("Seq", 8, 8), s("Distance", 16, 16, "mm"),
                              s("Angle", 32, 16, "deg", 0.1), from(0, 32767, s("Speed", 48, 16))};
constexpr Signal kMotor[] = {
    duty("Motor1", 0),  duty("Motor2", 8),
    duty("Motor3", 16), duty("Motor4", 24),
    u("Mask", 32, 4),   from(EYECAN_MOTOR_PERCENT, EYECAN_MOTOR_TICKS, u("Mode", 36, 4)),
    u("Seq", 40, 8)};
constexpr Signal kPid[] = {from(1, 4, u("Motor", 0, 8)), u("P", 8, 8), u("I", 16, 8),
                           u("D", 24, 8)};
constexpr Signal kServo[] = {
    from(0, 1, u("Bank", 0, 8)),     in_bank(0, u("Servo1", 8, 8)),
    in_bank(0, u("Servo2", 16, 8)),  in_bank(0, u("Servo3", 24, 8)),
    in_bank(0, u("Servo4", 32, 8)),  in_bank(0, u("Servo5", 40, 8)),
    in_bank(0, u("Servo6", 48, 8)),  in_bank(0, u("Servo7", 56, 8)),
    in_bank(1, u("Servo8", 8, 8)),   in_bank(1, u("Servo9", 16, 8)),
    in_bank(1, u("Servo10", 24, 8)), in_bank(1, u("Servo11", 32, 8)),
    in_bank(1, u("Servo12", 40, 8)), in_bank(1, u("Servo13", 48, 8)),
    in_bank(1, u("Servo14", 56, 8)),
};
constexpr Signal kSetDigital[] = {u("Mask", 0, 16), u("Value", 16, 16)};
constexpr Signal kDigitalCfg[] = {from(0, 15, u("Port", 0, 8)),
                                  from(EYECAN_PORT_INPUT, EYECAN_PORT_PULL_DOWN, u("Mode", 8, 8))};
constexpr Signal kAnalogA[] = {adc("Analog0", 0), adc("Analog1", 16), adc("Analog2", 32),
                               adc("Analog3", 48)};
constexpr Signal kAnalogB[] = {adc("Analog4", 0), adc("Analog5", 16), adc("Analog6", 32),
                               adc("Analog7", 48)};
constexpr Signal kStatus[] = {absent(from(0, 0xFFFE, u("Battery", 0, 16, "V", 0.01))),
                              adc("Microphone", 16), u("IrKey", 32, 8),
                              u("Uptime", 40, 24, "s", 0.1)};
constexpr Signal kLidarHdr[] = {u("ScanId", 0, 8), from(1, kMaxLidarPoints, u("Points", 8, 16)),
                                from(1, 360, u("Range", 24, 16, "deg")),
                                from(-90, 90, s("Tilt", 40, 8, "deg")), u("Time", 48, 16, "ms")};
constexpr Signal kLidarChunk[] = {u("ScanIdLow", 0, 4), u("Chunk", 4, 12), range_mm("Range0", 16),
                                  range_mm("Range1", 32), range_mm("Range2", 48)};
constexpr Signal kVersion[] = {u("Protocol", 0, 8),        character("Firmware1", 8),
                               character("Firmware2", 16), character("Firmware3", 24),
                               character("Firmware4", 32), u("Hardware", 40, 8),
                               u("Capabilities", 48, 16)};
constexpr Signal kHeartbeat[] = {from(0, 0x7F, u("State", 0, 8))};

constexpr std::string_view kFdNames[] = {
    "Range0",  "Range1",  "Range2",  "Range3",  "Range4",  "Range5",  "Range6",  "Range7",
    "Range8",  "Range9",  "Range10", "Range11", "Range12", "Range13", "Range14", "Range15",
    "Range16", "Range17", "Range18", "Range19", "Range20", "Range21", "Range22", "Range23",
    "Range24", "Range25", "Range26", "Range27", "Range28", "Range29"};
constexpr auto kLidarChunkFd = [] {
  std::array<Signal, 3 + std::size(kFdNames)> signals{};
  signals[0] = u("ScanId", 0, 8);
  signals[1] = from(1, std::size(kFdNames), u("Count", 8, 8));
  signals[2] = from(0, kMaxLidarPoints - 1, u("First", 16, 16));
  for (std::size_t i = 0; i < std::size(kFdNames); ++i) {
    signals[3 + i] = range_mm(kFdNames[i], static_cast<int>(32 + 16 * i));
  }
  return signals;
}();

// Rules that no single signal can state. The values come in the order of the signals.
using Values = std::span<const std::int64_t>;

constexpr bool known_command(Values v) {
  return v[0] == EYECAN_NMT_ENABLE || v[0] == EYECAN_NMT_STOP || v[0] == EYECAN_NMT_STANDBY ||
         v[0] == EYECAN_NMT_RESET;
}
constexpr bool known_state(Values v) {
  return v[0] == EYECAN_STATE_BOOT || v[0] == EYECAN_STATE_STOPPED ||
         v[0] == EYECAN_STATE_OPERATIONAL || v[0] == EYECAN_STATE_STANDBY;
}
constexpr bool percent_at_most_100(Values v) {
  constexpr std::size_t kMode = 5;
  if (v[kMode] != EYECAN_MOTOR_PERCENT) return true;
  return std::all_of(v.begin(), v.begin() + 4,
                     [](std::int64_t d) { return d >= -100 && d <= 100; });
}
constexpr bool within_a_scan(Values v) { return v[2] + v[1] <= kMaxLidarPoints; }

constexpr auto kToRobot = Direction::HostToRobot;
constexpr auto kToHost = Direction::RobotToHost;

constexpr MessageSpec kMessages[] = {
    {"C_Nmt", EYECAN_C_NMT, 0, 0, kToRobot, 2, 0, kNmt,
     "Command 1 enable, 2 stop, 128 standby, 129 reset; node 0 is all", known_command},
    {"C_EStop", EYECAN_C_ESTOP, 0, 14, kToRobot, 2, 100, kEStop,
     "Repeated while the stop is active; latched in the robot"},
    {"S_Fault", EYECAN_S_FAULT, 1, 14, kToHost, 8, 1000, kFault,
     "On change, at least 20 ms apart, repeated while set"},
    {"S_Pose", EYECAN_S_POSE, 1, 14, kToHost, 8, 20, kPose, "Odometry"},
    {"S_Speed", EYECAN_S_SPEED, 1, 14, kToHost, 8, 20, kSpeed, "Measured speed and state of moves"},
    {"S_Enc12", EYECAN_S_ENC12, 1, 14, kToHost, 8, 20, kEnc12, "Encoders since reset"},
    {"S_Enc34", EYECAN_S_ENC34, 1, 14, kToHost, 8, 100, kEnc34, "Encoders since reset"},
    {"S_PsdA", EYECAN_S_PSD_A, 1, 14, kToHost, 8, 50, kPsdA, "9999 is out of range"},
    {"S_PsdB", EYECAN_S_PSD_B, 1, 14, kToHost, 8, 50, kPsdB, "9999 is out of range"},
    {"S_PsdRaw", EYECAN_S_PSD_RAW, 1, 14, kToHost, 8, 50, kPsdRaw, "ADC values"},
    {"S_Digital", EYECAN_S_DIGITAL, 1, 14, kToHost, 6, 50, kDigital,
     "Bit n is port n; Outputs tells which are outputs; also on change"},
    {"C_VWSpeed", EYECAN_C_VW_SPEED, 1, 14, kToRobot, 6, 50, kVwSpeed,
     "While driving; 250 ms without it stop the robot"},
    {"C_VWMove", EYECAN_C_VW_MOVE, 1, 14, kToRobot, 8, 0, kVwMove,
     "1 straight, 2 turn, 3 curve, 4 drive; repeated until S_Speed echoes Seq"},
    {"C_SetPose", EYECAN_C_SET_POSE, 1, 14, kToRobot, 8, 0, kPose, "Sets the odometry"},
    {"C_Motor", EYECAN_C_MOTOR, 1, 14, kToRobot, 8, 50, kMotor,
     "Mode 0 percent -100..100, 1 ticks per 10 ms; bit n-1 of Mask is motor n",
     percent_at_most_100},
    {"C_Pid", EYECAN_C_PID, 1, 14, kToRobot, 4, 0, kPid, "Gains of the speed controller"},
    {.name = "C_Servo",
     .function = EYECAN_C_SERVO,
     .direction = kToRobot,
     .length = 8,
     .period_ms = 100,
     .signals = kServo,
     .comment = "Also on change",
     .multiplexed = true},
    {"C_Digital", EYECAN_C_DIGITAL, 1, 14, kToRobot, 4, 0, kSetDigital, "Bit n is port n"},
    {"C_DigitalCfg", EYECAN_C_DIGITAL_CFG, 1, 14, kToRobot, 2, 0, kDigitalCfg,
     "Mode 0 input, 1 output, 2 pull-up, 3 pull-down"},
    {"S_AnalogA", EYECAN_S_ANALOG_A, 1, 14, kToHost, 8, 100, kAnalogA, "ADC values"},
    {"S_AnalogB", EYECAN_S_ANALOG_B, 1, 14, kToHost, 8, 100, kAnalogB, "ADC values"},
    {"S_Status", EYECAN_S_STATUS, 1, 14, kToHost, 8, 100, kStatus,
     "Uptime going back is a restart"},
    {"S_LidarHdr", EYECAN_S_LIDAR_HDR, 1, 14, kToHost, 8, 0, kLidarHdr, "Before each scan"},
    {"S_LidarChunk", EYECAN_S_LIDAR_CHUNK, 1, 14, kToHost, 8, 0, kLidarChunk,
     "Points 3 Chunk to 3 Chunk + 2"},
    {.name = "S_LidarChunkFD",
     .function = EYECAN_S_LIDAR_CHUNK,
     .direction = kToHost,
     .length = 64,
     .signals = kLidarChunkFd,
     .comment = "Points First to First + Count - 1, on CAN FD buses instead of S_LidarChunk",
     .consistent = within_a_scan,
     .fd = true},
    {"S_Version", EYECAN_S_VERSION, 1, 14, kToHost, 8, 5000, kVersion,
     "At boot and on request, too; Firmware as IO7 v answers"},
    {"Heartbeat", EYECAN_HEARTBEAT, 1, 15, Direction::Both, 1, 100, kHeartbeat,
     "0 boot, 4 stopped, 5 operational, 127 standby; node 15 is the host", known_state},
};

constexpr bool well_formed(const MessageSpec& spec) {
  for (std::size_t i = 0; i < spec.signals.size(); ++i) {
    const Signal& a = spec.signals[i];
    if (a.length == 0 || a.length > 32 || a.start + a.length > 8 * spec.length) return false;
    if (a.first < lowest(a.length, a.is_signed) || a.last > highest(a.length, a.is_signed)) {
      return false;
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Signal& b = spec.signals[j];
      const bool apart = a.start + a.length <= b.start || b.start + b.length <= a.start;
      if (a.name == b.name || (!apart && (a.bank < 0 || b.bank < 0 || a.bank == b.bank)))
        return false;
    }
  }
  return spec.first_node <= spec.last_node && spec.length <= (spec.fd ? 64 : 8);
}
static_assert(std::all_of(std::begin(kMessages), std::end(kMessages), well_formed),
              "a signal overlaps another or lies outside its frame");

}  // namespace

std::span<const MessageSpec> messages() { return kMessages; }

const MessageSpec* find_message(std::string_view name) {
  const auto* found = std::find_if(std::begin(kMessages), std::end(kMessages),
                                   [name](const MessageSpec& row) { return row.name == name; });
  return found == std::end(kMessages) ? nullptr : found;
}

const MessageSpec* find_message(int function, bool fd) {
  // On the path of every frame: by index, not by search.
  static constexpr auto kRows = [] {
    std::array<std::array<const MessageSpec*, 128>, 2> rows{};
    for (const MessageSpec& row : kMessages) rows[row.fd ? 1 : 0][row.function] = &row;
    return rows;
  }();
  return function < 0 || function > 127 ? nullptr
                                        : kRows[fd ? 1 : 0][static_cast<std::size_t>(function)];
}

}  // namespace eyebridge::bridges::can
