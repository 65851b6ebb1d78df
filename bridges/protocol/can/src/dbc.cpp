// DBC files: as Vector's tools, cantools, canmatrix and SavvyCAN read them.
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/bridges/can/generated.hpp"
#include "eyebridge/bridges/can/table.hpp"

namespace eyebridge::bridges::can {
namespace {

constexpr int kStandardCan = 0;
constexpr int kStandardCanFd = 14;
constexpr std::string_view kHost = "Host";

struct Entry {
  const MessageSpec* spec;
  int node;
  std::string prefix;

  [[nodiscard]] std::string name() const { return prefix + std::string(spec->name); }
  [[nodiscard]] std::string id() const { return std::to_string(spec->id(node)); }
};

bool is_of_host(const Entry& entry) {
  return entry.spec->direction == Direction::HostToRobot || entry.node == kNodeHost;
}

std::string decimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::vector<std::string> robot_names(const DbcOptions& options) {
  if (options.robots == 0) return {"Robot"};
  std::vector<std::string> names;
  for (int node = 1; node <= options.robots; ++node)
    names.push_back("Robot" + std::to_string(node));
  return names;
}

/// The frames of all, then those of each robot: who has read the first robot has read them all.
std::vector<Entry> entries_of(const DbcOptions& options) {
  std::vector<const MessageSpec*> specs;
  for (const MessageSpec& spec : messages()) {
    const MessageSpec* other = find_message(spec.function, !spec.fd);
    if (spec.fd ? options.fd : other == nullptr || !options.fd) specs.push_back(&spec);
  }
  std::vector<Entry> entries;
  for (const MessageSpec* spec : specs) {
    const bool also_to_one = spec->last_node != kNodeAll;
    if (spec->first_node == kNodeAll && (options.robots > 0 || !also_to_one)) {
      entries.push_back({spec, kNodeAll, ""});
    }
    if (options.robots > 0 && spec->last_node == kNodeHost) {
      entries.push_back({spec, kNodeHost, "Host_"});
    }
    if (options.robots == 0 && also_to_one) entries.push_back({spec, kFirstNode, ""});
  }
  for (int node = 1; node <= options.robots; ++node) {
    for (const MessageSpec* spec : specs) {
      if (node <= spec->last_node)
        entries.push_back({spec, node, "R" + std::to_string(node) + "_"});
    }
  }
  return entries;
}

std::string receivers_of(const Entry& entry, const std::vector<std::string>& robots) {
  if (!is_of_host(entry)) return std::string(kHost);
  if (entry.node >= kFirstNode && entry.node <= kLastNode) {
    return robots[static_cast<std::size_t>(entry.node) - 1];
  }
  std::string all;
  for (const std::string& robot : robots) all += (all.empty() ? "" : ",") + robot;
  return all;
}

std::string signal_text(const Entry& entry, const Signal& signal, const std::string& receivers) {
  const bool selects = entry.spec->multiplexed && &signal == entry.spec->signals.data();
  std::string out = " SG_ " + std::string(signal.name);
  if (selects) out += " M";
  if (signal.bank >= 0) out += " m" + std::to_string(signal.bank);
  out += " : " + std::to_string(signal.start) + "|" + std::to_string(signal.length) + "@1";
  out += signal.is_signed ? "-" : "+";
  out += " (" + decimal(signal.scale) + "," + decimal(signal.offset) + ") [" +
         decimal(signal.physical(signal.first)) + "|" + decimal(signal.physical(signal.last)) +
         "] \"" + std::string(signal.unit) + "\" " + receivers + "\n";
  return out;
}

std::string message_text(const Entry& entry, const std::vector<std::string>& robots) {
  const std::string_view robot =
      is_of_host(entry) ? kHost
                        : std::string_view(robots[static_cast<std::size_t>(entry.node) - 1]);
  std::string out = "BO_ " + entry.id() + " " + entry.name() + ": " +
                    std::to_string(entry.spec->length) + " " + std::string(robot) + "\n";
  const std::string receivers = receivers_of(entry, robots);
  for (const Signal& signal : entry.spec->signals) out += signal_text(entry, signal, receivers);
  return out + "\n";
}

/// What a value table cannot say: sentences, and that its names are bits.
std::string comment_of(const Signal& signal) {
  std::string out(signal.comment);
  const auto add = [&out](const std::string& sentence) {
    out += (out.empty() ? "" : ". ") + sentence;
  };
  if (signal.names == nullptr) return out;
  if (signal.names->are_bits) add("Sum of bits");
  for (const Name& name : signal.names->names) {
    add(std::string(name.name) + ": " + std::string(name.meaning));
  }
  return out;
}

std::string comments_text(const std::vector<Entry>& entries,
                          const std::vector<std::string>& robots) {
  std::string out =
      "CM_ \"EyeBot I/O over CAN. Made by make_protocol from the table in bridges/protocol/can: do "
      "not edit.\";\nCM_ BU_ Host \"The program, node 15: commands, and a heartbeat\";\n";
  for (std::size_t i = 0; i < robots.size(); ++i) {
    out += "CM_ BU_ " + robots[i] + " \"Node " + std::to_string(i + 1) +
           ": its identifiers end in the hexadecimal digit " + "0123456789ABCDEF"[i + 1] + "\";\n";
  }
  for (const Entry& entry : entries) {
    out += "CM_ BO_ " + entry.id() + " \"" + std::string(entry.spec->comment) + "\";\n";
    for (const Signal& signal : entry.spec->signals) {
      const std::string comment = comment_of(signal);
      if (comment.empty()) continue;
      out += "CM_ SG_ " + entry.id() + " " + std::string(signal.name) + " \"" + comment + "\";\n";
    }
  }
  return out;
}

std::string attributes_text(const std::vector<Entry>& entries) {
  std::string out =
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

std::string values_text(const std::vector<Entry>& entries) {
  std::string out;
  for (const Entry& entry : entries) {
    for (const Signal& signal : entry.spec->signals) {
      std::string values;
      const auto add = [&](std::int64_t number, std::string_view name) {
        values += " " + std::to_string(number) + " \"" + std::string(name) + "\"";
      };
      if (signal.names != nullptr) {
        for (const Name& name : signal.names->names) add(name.number, name.name);
      }
      if (signal.may_be_absent) add(kAbsent, "ABSENT");
      if (values.empty()) continue;
      out += "VAL_ " + entry.id() + " " + std::string(signal.name) + values + " ;\n";
    }
  }
  return out;
}

}  // namespace

std::string write_dbc(const DbcOptions& options) {
  const std::vector<Entry> entries = entries_of(options);
  const std::vector<std::string> robots = robot_names(options);
  std::string out =
      "VERSION \"" + std::to_string(kProtocolVersion) + "\"\n\nNS_ :\n\nBS_:\n\nBU_: ";
  out += kHost;
  for (const std::string& robot : robots) out += " " + robot;
  out += "\n\n";
  for (const Entry& entry : entries) out += message_text(entry, robots);
  return out + comments_text(entries, robots) + attributes_text(entries) + values_text(entries);
}

}  // namespace eyebridge::bridges::can
