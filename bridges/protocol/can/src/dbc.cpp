#include "eyebridge/bridges/can/dbc.hpp"

#include <cstdio>
#include <string_view>
#include <vector>

#include "eyebridge/bridges/can/table.hpp"

namespace eyebridge::bridges::can {
namespace {

constexpr int kStandardCan = 0;
constexpr int kStandardCanFd = 14;

struct Entry {
  const MessageSpec* spec;
  int node;
  std::string prefix;

  [[nodiscard]] std::string name() const { return prefix + std::string(spec->name); }
  [[nodiscard]] std::string id() const { return std::to_string(spec->id(node)); }
};

std::string robot_name(const Entry& entry) {
  return entry.prefix.empty() ? "Robot" : "Robot" + std::to_string(entry.node);
}

bool from_host(const Entry& entry) {
  return entry.spec->direction == Direction::HostToRobot || entry.node == EYECAN_NODE_HOST;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::vector<Entry> entries_of(const DbcOptions& options) {
  std::vector<Entry> entries;
  for (const MessageSpec& spec : messages()) {
    const bool other_format =
        find_message(spec.function, !spec.fd) != nullptr && spec.fd != options.fd;
    if (other_format || (spec.fd && !options.fd)) continue;
    const bool to_all = spec.first_node == EYECAN_NODE_ALL;
    if (to_all && (options.robots > 0 || spec.last_node == EYECAN_NODE_ALL)) {
      entries.push_back({&spec, EYECAN_NODE_ALL, ""});
    }
    if (options.robots == 0 && spec.last_node != EYECAN_NODE_ALL) {
      entries.push_back({&spec, EYECAN_NODE_FIRST, ""});
    }
    for (int node = 1; node <= options.robots && node <= spec.last_node; ++node) {
      entries.push_back({&spec, node, "R" + std::to_string(node) + "_"});
    }
    if (options.robots > 0 && spec.last_node == EYECAN_NODE_HOST) {
      entries.push_back({&spec, EYECAN_NODE_HOST, "Host_"});
    }
  }
  return entries;
}

void add_signal(std::string& out, const Entry& entry, const Signal& signal,
                const std::string& receiver) {
  const bool selects = entry.spec->multiplexed && &signal == entry.spec->signals.data();
  out += " SG_ " + std::string(signal.name);
  if (selects) out += " M";
  if (signal.bank >= 0) out += " m" + std::to_string(signal.bank);
  out += " : " + std::to_string(signal.start) + "|" + std::to_string(signal.length) + "@1";
  out += signal.is_signed ? "-" : "+";
  out += " (" + number(signal.scale) + "," + number(signal.offset) + ") [" +
         number(signal.physical(signal.first)) + "|" + number(signal.physical(signal.last)) +
         "] \"" + std::string(signal.unit) + "\" " + receiver + "\n";
}

void add_message(std::string& out, const Entry& entry, bool many) {
  std::string robot = robot_name(entry);
  if (many && (entry.node == EYECAN_NODE_ALL || entry.node == EYECAN_NODE_HOST))
    robot = "Vector__XXX";
  const std::string sender = from_host(entry) ? "Host" : robot;
  const std::string receiver = from_host(entry) ? robot : "Host";
  out += "BO_ " + entry.id() + " " + entry.name() + ": " + std::to_string(entry.spec->length) +
         " " + sender + "\n";
  for (const Signal& signal : entry.spec->signals) add_signal(out, entry, signal, receiver);
  out += "\n";
}

}  // namespace

std::string write_dbc(const DbcOptions& options) {
  const std::vector<Entry> entries = entries_of(options);
  std::string out =
      "VERSION \"" + std::to_string(EYECAN_PROTOCOL_VERSION) + "\"\n\nNS_ :\n\nBS_:\n\nBU_: Host";
  if (options.robots == 0) out += " Robot";
  for (int node = 1; node <= options.robots; ++node) out += " Robot" + std::to_string(node);
  out += "\n\n";
  for (const Entry& entry : entries) add_message(out, entry, options.robots > 0);

  out +=
      "CM_ \"EyeBot I/O over CAN. Made by make_dbc from the table in bridges/protocol/can: do not "
      "edit.\";\n";
  for (const Entry& entry : entries) {
    out += "CM_ BO_ " + entry.id() + " \"" + std::string(entry.spec->comment) + "\";\n";
  }
  out +=
      "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\n"
      "BA_DEF_ BO_ \"VFrameFormat\" ENUM \"StandardCAN\",\"ExtendedCAN\",\"reserved\",\"J1939PG\","
      "\"reserved\",\"reserved\",\"reserved\",\"reserved\",\"reserved\",\"reserved\",\"reserved\","
      "\"reserved\",\"reserved\",\"reserved\",\"StandardCAN_FD\",\"ExtendedCAN_FD\";\n"
      "BA_DEF_DEF_ \"GenMsgCycleTime\" 0;\n"
      "BA_DEF_DEF_ \"VFrameFormat\" \"StandardCAN\";\n";
  for (const Entry& entry : entries) {
    if (entry.spec->period_ms > 0) {
      out += "BA_ \"GenMsgCycleTime\" BO_ " + entry.id() + " " +
             std::to_string(entry.spec->period_ms) + ";\n";
    }
    out += "BA_ \"VFrameFormat\" BO_ " + entry.id() + " " +
           std::to_string(entry.spec->fd ? kStandardCanFd : kStandardCan) + ";\n";
  }
  return out;
}

}  // namespace eyebridge::bridges::can
