#include "eyebridge/bridges/can/table.hpp"

#include <algorithm>
#include <array>

#include "names.hpp"
#include "signals.hpp"

namespace eyebridge::bridges::can {
namespace {

using namespace signals;

// Rules that no single signal can state. The values come in the order of the signals.
using Values = std::span<const std::int64_t>;

constexpr bool is_named(const NameGroup& group, std::int64_t value) {
  return std::ranges::any_of(group.names,
                             [value](const Name& name) { return name.number == value; });
}
constexpr bool known_command(Values v) { return is_named(names::kNmt, v[0]); }
constexpr bool known_state(Values v) { return is_named(names::kState, v[0]); }
constexpr bool percent_at_most_100(Values v) {
  constexpr std::size_t kMode = 5;
  if (v[kMode] != names::number(names::kMotor, "PERCENT")) return true;
  return std::all_of(v.begin(), v.begin() + 4,
                     [](std::int64_t d) { return d >= -100 && d <= 100; });
}
constexpr bool within_a_scan(Values v) { return v[2] + v[1] <= kMaxLidarPoints; }

/// From robots 1 … 14, unless said otherwise.
constexpr MessageSpec status(std::string_view name, std::string_view c_name, int function,
                             int period_ms, std::span<const Signal> signals,
                             std::string_view example, std::string_view comment) {
  return {.name = name,
          .c_name = c_name,
          .function = static_cast<std::uint8_t>(function),
          .period_ms = static_cast<std::uint16_t>(period_ms),
          .signals = signals,
          .example = example,
          .comment = comment};
}
/// To robots 1 … 14, unless said otherwise.
constexpr MessageSpec command(std::string_view name, std::string_view c_name, int function,
                              int length, int period_ms, std::span<const Signal> signals,
                              std::string_view example, std::string_view comment) {
  MessageSpec spec = status(name, c_name, function, period_ms, signals, example, comment);
  spec.direction = Direction::HostToRobot;
  spec.length = static_cast<std::uint8_t>(length);
  return spec;
}
constexpr MessageSpec of_length(int length, MessageSpec spec) {
  spec.length = static_cast<std::uint8_t>(length);
  return spec;
}
constexpr MessageSpec nodes(int first, int last, MessageSpec spec) {
  spec.first_node = static_cast<std::uint8_t>(first);
  spec.last_node = static_cast<std::uint8_t>(last);
  return spec;
}
constexpr MessageSpec if_consistent(bool (*rule)(Values), MessageSpec spec) {
  spec.consistent = rule;
  return spec;
}
constexpr MessageSpec banked(MessageSpec spec) {
  spec.multiplexed = true;
  return spec;
}
constexpr MessageSpec fd(MessageSpec spec) {
  spec.fd = true;
  return spec;
}
constexpr MessageSpec both_ways(MessageSpec spec) {
  spec.direction = Direction::Both;
  return spec;
}

constexpr MessageSpec kMessages[] = {
    nodes(
        kNodeAll, kNodeAll,
        if_consistent(known_command, command("C_Nmt", "C_NMT", 0x00, 2, 0, kNmt, "000#0103",
                                             "Switches robots on and off; always sent to node 0"))),
    nodes(kNodeAll, kLastNode,
          command("C_EStop", "C_ESTOP", 0x01, 2, 100, kEStop, "011#012A",
                  "Emergency stop, also to all (010); repeated while it is active, latched in the "
                  "robot")),
    status("S_Fault", "S_FAULT", 0x08, 1000, kFault, "081#2171030180563412",
           "On change, at least 20 ms apart; repeated while a fault is set"),
    status("S_Pose", "S_POSE", 0x18, 20, kPose, "183#C01DFED21E00D8DC",
           "Odometry; also at once after C_SetPose"),
    status("S_Speed", "S_SPEED", 0x19, 20, kSpeed, "191#06FF9411621124FA",
           "Measured speed and state of moves; also at once after a new C_VWMove"),
    status("S_Enc12", "S_ENC12", 0x1A, 20, kEnc12, "1A1#FFFFFFFFFFFFFF7F",
           "Encoders since restart"),
    status("S_Enc34", "S_ENC34", 0x1B, 100, kEnc34, "1B2#0000008000000100",
           "Encoders since restart"),
    status("S_PsdA", "S_PSD_A", 0x1C, 50, kPsdA, "1C1#00005E010F27FFFF",
           "Distances of the PSDs 1 to 4"),
    status("S_PsdB", "S_PSD_B", 0x1D, 50, kPsdB, "1D1#D204FFFFFF0FFFFF",
           "Distances and ADC values of the PSDs 5 and 6"),
    status("S_PsdRaw", "S_PSD_RAW", 0x1E, 50, kPsdRaw, "1E1#01000008FF0FFFFF",
           "ADC values of the PSDs 1 to 4"),
    of_length(6, status("S_Digital", "S_DIGITAL", 0x1F, 50, kDigital, "1F1#0180000F00FF",
                        "Bit n is port n; also on change")),
    command("C_VWSpeed", "C_VW_SPEED", 0x20, 6, 50, kVwSpeed, "201#2C01D8DC0700",
            "Drive at this speed; while driving, 250 ms without it stop the robot"),
    command("C_VWMove", "C_VW_MOVE", 0x21, 8, 0, kVwMove, "211#03C80CFE8403FA00",
            "A movement that ends by itself; repeated until S_Speed echoes Seq"),
    command("C_SetPose", "C_SET_POSE", 0x22, 8, 0, kPose, "224#E8030030F8FF5046",
            "Sets the odometry"),
    if_consistent(percent_at_most_100,
                  command("C_Motor", "C_MOTOR", 0x23, 8, 50, kMotor, "231#9C64FF0007090000",
                          "Drives motors one by one; 250 ms without it switch them off")),
    command("C_Pid", "C_PID", 0x24, 4, 0, kPid, "241#040A14FF", "Gains of the speed controller"),
    banked(command("C_Servo", "C_SERVO", 0x25, 8, 100, kServo, "255#00010203040506FF",
                   "Positions between the servos' limits; also on change")),
    command("C_Digital", "C_DIGITAL", 0x26, 4, 0, kSetDigital, "261#00FF00A5",
            "Sets outputs; bit n is port n"),
    command("C_DigitalCfg", "C_DIGITAL_CFG", 0x27, 2, 0, kDigitalCfg, "271#0F02",
            "Makes a port an input or an output"),
    status("S_AnalogA", "S_ANALOG_A", 0x28, 100, kAnalogA, "281#000001000200FF0F", "ADC values"),
    status("S_AnalogB", "S_ANALOG_B", 0x29, 100, kAnalogB, "291#FFFF050006000700", "ADC values"),
    status("S_Status", "S_STATUS", 0x2A, 100, kStatus, "2A1#E402FF070BA58C00",
           "State of the board"),
    status("S_LidarHdr", "S_LIDAR_HDR", 0x2C, 0, kLidarHdr, "2C1#5A68016801F6DCFF",
           "Before each scan"),
    status("S_LidarChunk", "S_LIDAR_CHUNK", 0x2D, 0, kLidarChunk, "2D1#7A07DC050F27FFFF",
           "Points 3 Chunk to 3 Chunk + 2"),
    fd(of_length(
        64, if_consistent(within_a_scan,
                          status("S_LidarChunkFD", "S_LIDAR_CHUNK", 0x2D, 0, kLidarChunkFd, "",
                                 "Points First to First + Count - 1, on CAN FD buses instead of "
                                 "S_LidarChunk")))),
    status("S_Zones", "S_ZONES", 0x2E, 0, kZones, "2E1#5207D2040F27FFFF",
           "Zones 3 Chunk to 3 Chunk + 2 of a range matrix: the top row first, each from the left"),
    status("S_Version", "S_VERSION", 0x48, 5000, kVersion, "481#01312E3034020301",
           "Who the robot is; also after a restart and when a remote frame asks"),
    nodes(kFirstNode, kNodeHost,
          both_ways(of_length(
              1, if_consistent(known_state,
                               status("Heartbeat", "HEARTBEAT", 0x70, 100, kHeartbeat, "701#05",
                                      "Also on change; node 15 is the host"))))),
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

// Quotes would end a DBC string, bars a cell of a Markdown table.
constexpr bool is_plain(std::string_view text) {
  return std::ranges::all_of(text,
                             [](char c) { return c >= ' ' && c < 0x7F && c != '"' && c != '|'; });
}
constexpr bool has_plain_texts(const MessageSpec& spec) {
  return is_plain(spec.comment) && std::ranges::all_of(spec.signals, [](const Signal& signal) {
           return is_plain(signal.comment);
         });
}
constexpr bool has_plain_names(const NameGroup* group) {
  return is_plain(group->title) && std::ranges::all_of(group->names, [](const Name& name) {
           return is_plain(name.name) && is_plain(name.meaning);
         });
}
static_assert(std::ranges::all_of(kMessages, has_plain_texts) &&
                  std::ranges::all_of(names::kAll, has_plain_names),
              "a text has a character that DBC files or tables cannot have");

}  // namespace

std::span<const MessageSpec> messages() { return kMessages; }

std::span<const NameGroup* const> name_groups() { return names::kAll; }

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
