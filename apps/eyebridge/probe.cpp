#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"
#include "eyebridge/bridges/open.hpp"
#include "eyebridge/bridges/trace.hpp"
#include "machine/can_state.hpp"
#include "machine/serial_ports.hpp"
#include "output_file.hpp"
#include "probe/can_census.hpp"
#include "probe/io7_board.hpp"
#include "probe/target.hpp"

namespace eyebridge::apps {
namespace {

struct ProbeFlags {
  std::string device;
  std::string root = "/";
  std::string listen = "1.5s";
  std::string patience = "3s";
  std::string trace;
};

template <class Line>
std::unique_ptr<Line> traced(std::unique_ptr<Line> line, Clock& clock, std::FILE* file) {
  if (file == nullptr) return line;
  return bridges::make_traced(std::move(line), clock, [file](std::string_view text) {
    std::fprintf(file, "%.*s\n", static_cast<int>(text.size()), text.data());
  });
}

int list_candidates(const std::string& root) {
  const SerialState serial = look_at_serial(root);
  const auto interfaces =
      can_interfaces(root, root == "/" ? ask_can_links() : std::vector<CanLink>{});
  std::string first;
  for (const SerialPort& port : serial.ports) {
    std::printf("%-16s %s\n", port.device.c_str(), described(port).c_str());
    if (!port.by_id.empty()) std::printf("%-16s %s\n", "", port.by_id.c_str());
    if (first.empty()) first = port.device;
  }
  for (const CanInterface& interface : interfaces) {
    std::printf("%-16s %s\n", ("can:" + interface.name).c_str(), described(interface).c_str());
    if (first.empty()) first = "can:" + interface.name;
  }
  if (first.empty()) {
    std::puts(
        "Found no serial port (/dev/ttyACM*, /dev/ttyUSB*, /dev/ttyAMA*) and no CAN interface.");
    first = "/dev/ttyACM0";
  }
  std::printf("What is on one of them:  eyebridge probe %s\n", first.c_str());
  std::puts("Over the network:        eyebridge probe tcp:HOST:PORT");
  return kFine;
}

void print_advice(const std::string& device) {
  for (const std::string& line : advice_on(device))
    std::printf("  %-12s %s\n", "note", printable(line).c_str());
}

int probe_io7(const ProbeTarget& target, const ProbeFlags& flags) {
  const SourceLocation where{flags.device};
  const Time patience = from_seconds(parse_duration(flags.patience, {"--patience"}));
  const bool is_serial = target.line.scheme == "serial";
  const unsigned baud = is_serial ? bridges::serial_settings(target.line, where).baud : 0;
  const OutputFile trace = open_output(flags.trace, kTraceOutput);
  bridges::MonotonicClock clock;
  auto stream = bridges::open_stream(target.line, where, clock);
  if (!stream) {
    throw ConfigError(
        {}, is_serial ? why_not_opened(target.line.rest, stream.error()) : stream.error().what);
  }
  const std::string name((*stream)->name());
  LineCounts counts;
  const auto board =
      look_at_io7(traced(std::move(*stream), clock, trace.get()), clock, patience, counts);
  if (!board) throw ConfigError({name}, why_no_board(board.error(), counts, baud));
  std::printf("%s: %s", name.c_str(), printable(described(*board, target.url)).c_str());
  if (is_serial) print_advice(target.line.rest);
  return kFine;
}

int probe_can(const ProbeTarget& target, const ProbeFlags& flags) {
  const Time span = from_seconds(parse_duration(flags.listen, {"--listen"}));
  const std::string& name = target.line.rest;
  const SourceLocation where{flags.device};
  bridges::SocketCanSettings settings = bridges::socket_can_settings(target.line, where);
  const CanState state = look_at_can();
  const CanInterface* interface = nullptr;
  for (const CanInterface& candidate : state.interfaces) {
    if (candidate.name == name) interface = &candidate;
  }
  settings.fd = settings.fd || (interface != nullptr && interface->takes_fd);
  const OutputFile trace = open_output(flags.trace, kTraceOutput);
  bridges::MonotonicClock clock;
  auto bus = bridges::open_socket_can(settings, clock);
  if (!bus) throw ConfigError({}, why_not_opened(state, name, bus.error()));
  if (interface != nullptr) std::printf("%s: %s\n", name.c_str(), described(*interface).c_str());
  std::fflush(stdout);
  const auto traced_bus = traced(std::move(*bus), clock, trace.get());
  const auto census = listen_to(*traced_bus, clock, span);
  if (!census) throw ConfigError({}, census.error().what);
  std::fputs(printable(described(*census, name)).c_str(), stdout);
  std::fflush(stdout);
  if (census->robots.empty()) {
    throw ConfigError({name},
                      fmt::format("no robot was heard for {}; expected its heartbeat ten times a "
                                  "second: is it switched on, has the bus the same bit rate "
                                  "everywhere and a 120 ohm resistor at both ends?",
                                  flags.listen));
  }
  if (target.node != 0 && !census->robots.contains(target.node)) {
    throw ConfigError({name}, fmt::format("robot {} was not heard for {}; expected one of those "
                                          "above",
                                          target.node, flags.listen));
  }
  return kFine;
}

int probe(const ProbeFlags& flags) {
  if (flags.device.empty()) return list_candidates(flags.root);
  const ProbeTarget target = probe_target(flags.device);
  return target.line.scheme == "can" ? probe_can(target, flags) : probe_io7(target, flags);
}

}  // namespace

void add_probe(CLI::App& root, int& code) {
  CLI::App* command =
      root.add_subcommand("probe", "Says what board is on a serial port, TCP port or CAN bus");
  const auto flags = std::make_shared<ProbeFlags>();
  command
      ->add_option("DEVICE", flags->device,
                   "/dev/ttyACM0, serial:…, tcp:HOST:PORT or can:INTERFACE; without it: a list")
      ->type_name("");
  command->add_option("--patience", flags->patience, "How long a board may take to answer [3s]")
      ->type_name("TIME");
  command->add_option("--listen", flags->listen, "How long a CAN bus is listened to [1.5s]")
      ->type_name("TIME");
  command->add_option("--trace", flags->trace, "Writes down all bytes and frames")
      ->type_name("FILE");
  command->add_option("--root", flags->root, "Lists the devices below FOLDER instead of /")
      ->type_name("FOLDER");
  command->footer(
      "Sends nothing that could move a robot: questions to boards whose own list has them, and on\n"
      "CAN a question for the version. Exit code 2 when there is no such device or no such board.");
  command->callback([flags, &code] { code = probe(*flags); });
}

}  // namespace eyebridge::apps
