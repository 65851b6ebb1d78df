#pragma once

#include <array>
#include <iterator>
#include <string_view>

#include "eyebridge/bridges/can/table.hpp"
#include "names.hpp"

namespace eyebridge::bridges::can::signals {

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
          .last = highest(length, false),
          .comment = ""};
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
constexpr Signal note(std::string_view comment, Signal signal) {
  signal.comment = comment;
  return signal;
}
constexpr Signal named(const NameGroup& group, Signal signal) {
  signal.names = &group;
  return signal;
}
/// One of consecutive names.
constexpr Signal one_of(const NameGroup& group, Signal signal) {
  return from(group.names.front().number, group.names.back().number, named(group, signal));
}
constexpr Signal range_mm(std::string_view name, int start) {
  return absent(named(names::kPsd, from(0, kOutOfRange, u(name, start, 16, "mm"))));
}
constexpr Signal adc(std::string_view name, int start) {
  return absent(from(0, 4095, u(name, start, 16)));
}
constexpr Signal flag(std::string_view name, int start) { return u(name, start, 1); }
constexpr Signal character(std::string_view name, int start) {
  return from(0x20, 0x7E, u(name, start, 8));
}
constexpr Signal seq(int start) {
  return note("Counts up; for traces, a robot does not look at it", u("Seq", start, 8));
}
constexpr Signal motor(std::string_view name, int start) { return s(name, start, 8); }
constexpr Signal servo(std::string_view name, int bank, int start) {
  return in_bank(bank, u(name, start, 8));
}

inline constexpr Signal kNmt[] = {
    named(names::kNmt, u("Command", 0, 8)),
    named(names::kAddress, note("The robot that is meant", from(0, kLastNode, u("Node", 8, 8))))};
inline constexpr Signal kEStop[] = {one_of(names::kEStop, u("Reason", 0, 8)), seq(8)};
inline constexpr Signal kFault[] = {
    named(names::kFault, u("Code", 0, 16)), named(names::kRegister, u("Register", 16, 8)),
    named(names::kFlags, u("Flags", 24, 16)),
    note("Depends on Code: identifier of a frame in bits 0 to 10, its length in bits 16 to 23; "
         "else 0",
         u("Aux", 40, 24))};
inline constexpr Signal kPose[] = {
    note("Forward, where the robot looks at Phi 0", s("X", 0, 24, "mm")),
    note("To the left", s("Y", 24, 24, "mm")),
    note("Counter-clockwise; S_Pose has -180 to 179.99, C_SetPose may have more",
         s("Phi", 48, 16, "deg", 0.01))};
inline constexpr Signal kSpeed[] = {
    note("Forward, as measured", s("V", 0, 16, "mm/s")),
    note("Counter-clockwise, as measured", s("W", 16, 16, "deg/s", 0.01)),
    one_of(names::kMove, u("MoveState", 32, 4)),
    note("The left wheel should turn and does not", flag("StallLeft", 36)),
    note("The right wheel should turn and does not", flag("StallRight", 37)),
    note("1 while operational", flag("MotorsEnabled", 38)),
    note("1 after 250 ms without C_VWSpeed or C_Motor, until the next command that drives",
         flag("CommandTimeout", 39)),
    note("Seq of the C_VWMove that was executed last; 0 before the first", u("LastMoveSeq", 40, 8)),
    note("Way that the move has left; 0 without a move and for turns",
         s("Remaining", 48, 16, "mm"))};
inline constexpr Signal kEnc12[] = {
    note("Of motor 1, the left wheel; positive forward, wraps", s("Encoder1", 0, 32, "ticks")),
    note("Of motor 2, the right wheel", s("Encoder2", 32, 32, "ticks"))};
inline constexpr Signal kEnc34[] = {s("Encoder3", 0, 32, "ticks"), s("Encoder4", 32, 32, "ticks")};
inline constexpr Signal kPsdA[] = {range_mm("Psd1", 0), range_mm("Psd2", 16), range_mm("Psd3", 32),
                                   range_mm("Psd4", 48)};
inline constexpr Signal kPsdB[] = {range_mm("Psd5", 0), range_mm("Psd6", 16), adc("Psd5Raw", 32),
                                   adc("Psd6Raw", 48)};
inline constexpr Signal kPsdRaw[] = {adc("Psd1Raw", 0), adc("Psd2Raw", 16), adc("Psd3Raw", 32),
                                     adc("Psd4Raw", 48)};
inline constexpr Signal kDigital[] = {
    note("Levels of all ports; an output reads as itself", u("In", 0, 16)),
    note("Levels of the outputs; 0 for inputs", u("Out", 16, 16)),
    note("Which ports are outputs", u("Outputs", 32, 16))};
inline constexpr Signal kVwSpeed[] = {
    note("Forward", s("V", 0, 16, "mm/s")),
    note("Counter-clockwise", s("W", 16, 16, "deg/s", 0.01)), seq(32),
    note("0 in this version; a robot does not look at it", u("Flags", 40, 8))};
inline constexpr Signal kVwMove[] = {
    one_of(names::kVw, u("Type", 0, 8)),
    note("Number of the move: another one than LastMoveSeq", u("Seq", 8, 8)),
    note("Of the path; negative is backwards", s("Distance", 16, 16, "mm")),
    note("Counter-clockwise", s("Angle", 32, 16, "deg", 0.1)),
    note("mm/s, for turns deg/s; its sign is that of Distance or Angle",
         from(0, 32767, s("Speed", 48, 16)))};
inline constexpr Signal kMotor[] = {
    note("Left wheel", motor("Motor1", 0)),
    note("Right wheel", motor("Motor2", 8)),
    motor("Motor3", 16),
    motor("Motor4", 24),
    note("Bit n-1: motor n is meant; the others keep what they have", u("Mask", 32, 4)),
    one_of(names::kMotor, u("Mode", 36, 4)),
    seq(40)};
inline constexpr Signal kPid[] = {from(1, 4, u("Motor", 0, 8)), u("P", 8, 8), u("I", 16, 8),
                                  u("D", 24, 8)};
inline constexpr Signal kServo[] = {
    note("Which servos the frame has: 0 for 1 to 7, 1 for 8 to 14", from(0, 1, u("Bank", 0, 8))),
    servo("Servo1", 0, 8),
    servo("Servo2", 0, 16),
    servo("Servo3", 0, 24),
    servo("Servo4", 0, 32),
    servo("Servo5", 0, 40),
    servo("Servo6", 0, 48),
    servo("Servo7", 0, 56),
    servo("Servo8", 1, 8),
    servo("Servo9", 1, 16),
    servo("Servo10", 1, 24),
    servo("Servo11", 1, 32),
    servo("Servo12", 1, 40),
    servo("Servo13", 1, 48),
    servo("Servo14", 1, 56),
};
inline constexpr Signal kSetDigital[] = {
    note("Which ports are meant; the others keep their level", u("Mask", 0, 16)),
    note("Their levels", u("Value", 16, 16))};
inline constexpr Signal kDigitalCfg[] = {from(0, 15, u("Port", 0, 8)),
                                         one_of(names::kPort, u("Mode", 8, 8))};
inline constexpr Signal kAnalogA[] = {
    note("The supply, where the board measures it there", adc("Analog0", 0)), adc("Analog1", 16),
    adc("Analog2", 32), adc("Analog3", 48)};
inline constexpr Signal kAnalogB[] = {adc("Analog4", 0), adc("Analog5", 16), adc("Analog6", 32),
                                      adc("Analog7", 48)};
inline constexpr Signal kStatus[] = {
    note("Supply", absent(from(0, 0xFFFE, u("Battery", 0, 16, "V", 0.01)))),
    note("ADC value", adc("Microphone", 16)),
    named(names::kIr, note("Last key of the infrared remote control, as IRTVGet returns it",
                           u("IrKey", 32, 8))),
    note("Since power-up or restart, wraps; going back is a restart",
         u("Uptime", 40, 24, "s", 0.1))};
inline constexpr Signal kLidarHdr[] = {
    note("Counts up", u("ScanId", 0, 8)), from(1, kMaxLidarPoints, u("Points", 8, 16)),
    note("Field of view, centred on the front", from(1, 360, u("Range", 24, 16, "deg"))),
    note("Downwards", from(-90, 90, s("Tilt", 40, 8, "deg"))),
    note("Of the robot's clock, wraps", u("Time", 48, 16, "ms"))};
inline constexpr Signal kLidarChunk[] = {
    note("Lowest 4 bits of the header's ScanId", u("ScanIdLow", 0, 4)),
    note("Counts from 0", u("Chunk", 4, 12)), range_mm("Range0", 16), range_mm("Range1", 32),
    range_mm("Range2", 48)};
inline constexpr Signal kZones[] = {
    note("Number of the range matrix", from(1, kMostMatrices, u("Matrix", 0, 4))),
    note("Counts up; the same in all frames of one reading", u("Reading", 4, 4)),
    note("Counts from 0 to 21", from(0, kLastZoneChunk, u("Chunk", 8, 8))),
    range_mm("Range0", 16),
    range_mm("Range1", 32),
    range_mm("Range2", 48)};
inline constexpr Signal kVersion[] = {
    note("Version of this protocol: 1", u("Protocol", 0, 8)),
    note("ASCII, as the letter v of IO7 answers", character("Firmware1", 8)),
    character("Firmware2", 16),
    character("Firmware3", 24),
    character("Firmware4", 32),
    named(names::kHardware, u("Hardware", 40, 8)),
    named(names::kCapable, u("Capabilities", 48, 16))};
inline constexpr Signal kHeartbeat[] = {named(names::kState, from(0, 0x7F, u("State", 0, 8)))};

inline constexpr std::string_view kFdNames[] = {
    "Range0",  "Range1",  "Range2",  "Range3",  "Range4",  "Range5",  "Range6",  "Range7",
    "Range8",  "Range9",  "Range10", "Range11", "Range12", "Range13", "Range14", "Range15",
    "Range16", "Range17", "Range18", "Range19", "Range20", "Range21", "Range22", "Range23",
    "Range24", "Range25", "Range26", "Range27", "Range28", "Range29"};
inline constexpr auto kLidarChunkFd = [] {
  std::array<Signal, 3 + std::size(kFdNames)> signals{};
  signals[0] = note("The header's ScanId", u("ScanId", 0, 8));
  signals[1] = note("Points in use", from(1, std::size(kFdNames), u("Count", 8, 8)));
  signals[2] = note("Index of the first point", from(0, kMaxLidarPoints - 1, u("First", 16, 16)));
  for (std::size_t i = 0; i < std::size(kFdNames); ++i) {
    signals[3 + i] = range_mm(kFdNames[i], static_cast<int>(32 + 16 * i));
  }
  return signals;
}();

}  // namespace eyebridge::bridges::can::signals
