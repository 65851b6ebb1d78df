#pragma once

#include <stdexcept>
#include <string_view>

#include "eyebridge/bridges/can/table.hpp"

// Texts go into C comments, DBC strings and a Markdown table: ASCII, without quotes and bars.
namespace eyebridge::bridges::can::names {

inline constexpr Name kLayoutNames[] = {
    {"NODE_BITS", kNodeBits, "Lowest bits of an identifier: the node"},
    {"NODE_FIRST", kFirstNode, "First robot"},
    {"NODE_LAST", kLastNode, "Last robot"},
    {"NODE_HOST", kNodeHost, "The host"},
    {"PROTOCOL_VERSION", kProtocolVersion, "S_Version Protocol"},
};
inline constexpr NameGroup kLayout{"", "Identifiers and version", kLayoutNames};

inline constexpr Name kMaskNames[] = {
    {"NODE_MASK", kNodeMask, "Identifier & this: the node"},
    {"FUNCTION_MASK", kFunctionMask, "Identifier & this: the function << NODE_BITS"},
};
inline constexpr NameGroup kMasks{"", "Masks of identifiers", kMaskNames, 3};

inline constexpr Name kAddressNames[] = {{"ALL", kNodeAll, "All robots"}};
inline constexpr NameGroup kAddress{"NODE_", "C_Nmt Node; 1 to 14 are robots", kAddressNames};

inline constexpr Name kBulkNames[] = {
    {"RESPONSE", 0x58, "Reserved for ISO-TP from the robot; optional, not described here"},
    {"REQUEST", 0x60, "Reserved for ISO-TP to the robot; optional, not described here"},
};
inline constexpr NameGroup kBulk{"BULK_", "Functions without a message", kBulkNames, 2};

inline constexpr Name kAbsentNames[] = {
    {"ABSENT", kAbsent, "No such sensor or point, or not measured"}};
inline constexpr NameGroup kAbsents{"", "Unsigned 16-bit values that may be absent", kAbsentNames,
                                    4};
inline constexpr Name kPsdNames[] = {{"OUT_OF_RANGE", kOutOfRange, "Nothing within reach"}};
inline constexpr NameGroup kPsd{"PSD_", "Ranges of PSDs, LIDAR points and zones, mm", kPsdNames};

inline constexpr Name kNmtNames[] = {
    {"ENABLE", 0x01, "Become operational, with speed 0; ends an emergency stop that is over"},
    {"STOP", 0x02, "Motors off, state STOPPED"},
    {"STANDBY", 0x80, "Motors off, state STANDBY"},
    {"RESET", 0x81, "Restart as after power-up: odometry, encoders and parameters are lost"},
};
inline constexpr NameGroup kNmt{"NMT_", "C_Nmt Command", kNmtNames, 2, false, true};

inline constexpr Name kStateNames[] = {
    {"BOOT", 0x00, "Has just started; the first frame of a robot and no later one"},
    {"STOPPED", 0x04, "Motors off after NMT STOP or an emergency stop"},
    {"OPERATIONAL", 0x05, "Takes commands that move something; the host always sends this"},
    {"STANDBY", 0x7F, "Motors off: not enabled yet, NMT STANDBY, or the host is lost"},
};
inline constexpr NameGroup kState{"STATE_", "Heartbeat State", kStateNames, 2, false, true};

inline constexpr Name kEStopNames[] = {
    {"USER", 1, "Somebody pressed a button"},
    {"PROGRAM_END", 2, "The program has ended"},
    {"HOST_FAULT", 3, "The host found a fault; also sent by the guard of a crashed program"},
};
inline constexpr NameGroup kEStop{
    "ESTOP_", "C_EStop Reason; a robot treats all alike", kEStopNames, 0, false, true};

inline constexpr Name kFaultNames[] = {
    {"NONE", 0x0000, "No fault any more"},
    {"LOW_BATTERY", 0x3120, "Steady: the supply is below the robot's limit"},
    {"MOTOR_BLOCKED", 0x7121, "Steady: a wheel is held (StallLeft, StallRight)"},
    {"HOST_LOST", 0x8130, "Steady: 300 ms without heartbeat of the host while operational"},
    {"BUS_OFF_RECOVERED", 0x8140, "Event: the robot had left the bus and is back"},
    {"DUPLICATE_NODE", 0x8150, "Steady: another node sends under this one's number"},
    {"FRAME_LENGTH", 0x8210, "Event: a frame was too short; Aux is identifier + length << 16"},
    {"BAD_VALUE", 0x8220, "Event: a frame had a value that it may not have; Aux is identifier"},
    {"ESTOP", 0xFF01, "Steady: emergency stop"},
    {"COMMAND_TIMEOUT", 0xFF02, "Steady: 250 ms without C_VWSpeed or C_Motor while one drove"},
};
inline constexpr NameGroup kFault{"FAULT_", "S_Fault Code, in the classes of CANopen", kFaultNames,
                                  4};

inline constexpr Name kRegisterNames[] = {
    {"ANY", 1, "Any fault"},
    {"CURRENT", 2, "Codes 7xxx"},
    {"VOLTAGE", 4, "Codes 3xxx"},
    {"COMMUNICATION", 16, "All other codes"},
};
inline constexpr NameGroup kRegister{"REGISTER_", "S_Fault Register, as in CANopen", kRegisterNames,
                                     2, true};

inline constexpr Name kFlagNames[] = {
    {"ESTOP", 0x01, "Fault ESTOP is set"},
    {"DUPLICATE_NODE", 0x02, "Fault DUPLICATE_NODE is set"},
    {"HOST_LOST", 0x04, "Fault HOST_LOST is set"},
    {"COMMAND_TIMEOUT", 0x08, "Fault COMMAND_TIMEOUT is set"},
    {"MOTOR_BLOCKED", 0x10, "Fault MOTOR_BLOCKED is set"},
    {"LOW_BATTERY", 0x20, "Fault LOW_BATTERY is set"},
};
inline constexpr NameGroup kFlags{
    "FLAG_", "S_Fault Flags: all steady faults, the most important first", kFlagNames, 2, true};

inline constexpr Name kMoveNames[] = {
    {"IDLE", 0,
     "Nothing commanded since the start, or motors off or C_Motor while no move was under way"},
    {"SPEED", 1, "The last command was C_VWSpeed, also with speed 0 or after its time-out"},
    {"RUNNING", 2, "The move LastMoveSeq is under way"},
    {"DONE", 3, "The move has ended where it should"},
    {"ABORTED", 4,
     "The last move was given up: motors off or C_Motor meanwhile, or a wheel was held too long"},
};
inline constexpr NameGroup kMove{"MOVE_", "S_Speed MoveState", kMoveNames, 0, false, true};

inline constexpr Name kVwNames[] = {
    {"STRAIGHT", 1, "Distance counts, Angle is ignored; Speed in mm/s"},
    {"TURN", 2, "On the spot: Angle counts, Distance is ignored; Speed in deg/s"},
    {"CURVE", 3, "An arc of length Distance that turns by Angle; Speed in mm/s along it"},
    {"DRIVE", 4, "As CURVE"},
};
inline constexpr NameGroup kVw{"VW_", "C_VWMove Type", kVwNames, 0, false, true};

inline constexpr Name kMotorNames[] = {
    {"PERCENT", 0, "Duty, -100 to 100 %"},
    {"TICKS", 1, "Speed control, -128 to 127 encoder ticks per 10 ms"},
};
inline constexpr NameGroup kMotor{"MOTOR_", "C_Motor Mode", kMotorNames, 0, false, true};

inline constexpr Name kPortNames[] = {
    {"INPUT", 0, "Input without resistor"},
    {"OUTPUT", 1, "Output; its level is that of the last C_Digital"},
    {"PULL_UP", 2, "Input with resistor to supply"},
    {"PULL_DOWN", 3, "Input with resistor to ground"},
};
inline constexpr NameGroup kPort{"PORT_", "C_DigitalCfg Mode", kPortNames, 0, false, true};

inline constexpr Name kIrNames[] = {{"NONE", 0, "No key"}};
inline constexpr NameGroup kIr{"IR_", "S_Status IrKey; others are codes of keys", kIrNames};

inline constexpr Name kHardwareNames[] = {
    {"UNKNOWN", 0, "Not told"},
    {"EYEBOT_IO", 1, "EyeBot I/O board, or firmware-stubs in its place"},
};
inline constexpr NameGroup kHardware{
    "HARDWARE_", "S_Version Hardware: for people, a host takes any; 128 to 255 are for your boards",
    kHardwareNames};

inline constexpr Name kCapableNames[] = {
    {"MOVES", 0x0001, "Executes C_VWMove by itself"},
    {"SCANS", 0x0002, "Sends LIDAR scans: the host waits for the first one when it starts"},
    {"ZONES", 0x0100,
     "Sends readings of range matrix 1, the next bits up to 0x8000: of 2 to 8; as for SCANS"},
};
inline constexpr NameGroup kCapable{"CAPABLE_OF_", "S_Version Capabilities; other bits are 0",
                                    kCapableNames, 4, true};

inline constexpr const NameGroup* kAll[] = {
    &kLayout,   &kMasks, &kAddress, &kBulk, &kAbsents, &kPsd,  &kNmt, &kState,    &kEStop,  &kFault,
    &kRegister, &kFlags, &kMove,    &kVw,   &kMotor,   &kPort, &kIr,  &kHardware, &kCapable};

/// The number of `name`; does not compile when there is none.
consteval std::int64_t number(const NameGroup& group, std::string_view name) {
  for (const Name& entry : group.names) {
    if (entry.name == name) return entry.number;
  }
  throw std::invalid_argument("no such name");
}

}  // namespace eyebridge::bridges::can::names
