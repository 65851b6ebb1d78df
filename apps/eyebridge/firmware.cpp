#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <poll.h>

#include "command.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/pins/board_world.hpp"
#include "eyebridge/pins/psd_table.hpp"
#include "eyebridge/ports/can_hub.hpp"
#include "firmware_parts.hpp"
#include "path_file.hpp"
#include "stop_signals.hpp"

namespace eyebridge::apps {
namespace {

/// Runs the boards until a signal comes.
class FirmwareRun {
 public:
  FirmwareRun(const FirmwareOptions& options, const files::Scenario& scenario)
      : options_(options),
        world_(scenario),
        start_(monotonic_now()),
        trace_(options.trace),
        path_(options.path) {}

  void open(const std::vector<WantedBoard>& wanted) {
    if (wanted.size() > world_.robots()) {
      throw ConfigError({options_.world},
                        fmt::format("found {} robot(s), expected one for each of {} boards",
                                    world_.robots(), wanted.size()));
    }
    serve_buses(wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const auto robot = static_cast<robot::RobotIndex>(i);
      ports_.push_back(
          wanted[i].kind == WantedBoard::Kind::Rover
              ? open_rover(world_.add_rover(robot), wanted[i])
              : open_port(world_.add_board(robot, board_config(options_, wanted[i])), wanted[i]));
    }
    print_start(ports_, options_.world);
  }

  void run() {
    while (!stop_asked()) {
      const Time due = world_.advance(now());
      path_.note(now(), world_.simulation(), ports_.size());
      pump();
      wait(due);
      pump();
    }
    print_end(now(), world_, ports_.size());
  }

 private:
  [[nodiscard]] Time now() const { return monotonic_now() - start_; }

  /// A bus on a socket is served by the first process that names it.
  void serve_buses(const std::vector<WantedBoard>& wanted) {
    for (const WantedBoard& board : wanted) {
      const bool is_can =
          board.kind == WantedBoard::Kind::Can || board.kind == WantedBoard::Kind::Rover;
      if (!is_can || !ports::is_can_path(board.name)) continue;
      if (auto hub = ports::open_can_hub(board.name, {"--can"})) hubs_.push_back(std::move(hub));
    }
  }

  std::unique_ptr<ports::Port> open_port(eb_board& board, const WantedBoard& wanted) {
    if (wanted.kind == WantedBoard::Kind::Can) {
      const ports::FrameLine line = trace_.traced(ports::frame_line(board), wanted.name);
      return ports::open_can(line, wanted.name, options_.fd, wanted.node, {"--can"},
                             {options_.offset, options_.ids == 29});
    }
    return open_byte_port(trace_.traced(ports::byte_line(board)), wanted);
  }

  std::unique_ptr<ports::Port> open_rover(rv_rover& rover, const WantedBoard& wanted) {
    const ports::FrameLine line = trace_.traced(ports::frame_line(rover), wanted.name);
    return ports::open_can(line, wanted.name, options_.fd, wanted.node, {"--can"});
  }

  void pump() {
    for (const auto& hub : hubs_) hub->pump();
    for (const auto& port : ports_) port->pump();
    for (const auto& hub : hubs_) hub->pump();
  }

  void wait(Time due) {
    polled_.clear();
    for (const auto& port : ports_) {
      const short events = port->wants_room() ? POLLIN | POLLOUT : POLLIN;
      polled_.push_back({port->descriptor(), events, 0});
    }
    for (const auto& hub : hubs_) polled_.push_back({hub->descriptor(), POLLIN, 0});
    const Time left = std::max(due - now(), Time{});
    const timespec timeout{0, static_cast<long>(std::min<Time::rep>(left.count(), 20'000'000))};
    ::ppoll(polled_.data(), polled_.size(), &timeout, nullptr);
  }

  FirmwareOptions options_;
  pins::BoardWorld world_;
  Time start_;
  FirmwareTrace trace_;
  PathFile path_;
  std::vector<std::unique_ptr<ports::Port>> hubs_;
  std::vector<std::unique_ptr<ports::Port>> ports_;
  std::vector<pollfd> polled_;
};

int run_boards(const FirmwareOptions& options, const files::Scenario& scenario,
               const std::vector<WantedBoard>& wanted) {
  FirmwareRun run(options, scenario);
  stop_on_signals();
  run.open(wanted);
  run.run();
  return kFine;
}

int run_firmware(const CLI::App& command, const FirmwareOptions& options) {
  const files::Scenario scenario =
      files::load_scenario(options.world, {.robot = options.robot, .robot_where = {"--robot"}});
  for (const Warning& warning : scenario.warnings) {
    tell(warning.str());
  }
  if (scenario.robots.empty()) {
    throw ConfigError({options.world}, "found no robot, expected at least one");
  }
  if (options.hdt) {
    std::fputs(pins::hdt_text(scenario.models.at(scenario.robots.front().model)).c_str(), stdout);
    return kFine;
  }
  const std::vector<WantedBoard> wanted = wanted_boards(command, options);
  if (!options.elf.empty() && !options.cortex_m3) {
    throw ConfigError({"--elf"}, "found no --cortex-m3, expected what is to run it");
  }
  try {
    return options.cortex_m3 ? run_emulated(options, scenario, wanted)
                             : run_boards(options, scenario, wanted);
  } catch (const std::invalid_argument& error) {
    throw ConfigError({options.world}, error.what());
  }
}

}  // namespace

void add_firmware(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand(
      "firmware", "Runs EyeBot I/O boards that drive the robots of a simulated world");
  auto o = std::make_shared<FirmwareOptions>();
  command->add_option("--world", o->world, "World, maze or scenario file")
      ->required()
      ->type_name("WORLD");
  command->add_option("--robot", o->robot, "Robot of a world that has none [S4]");
  command->add_option("--pty", o->ptys, "A board on a pseudo-terminal with this name")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command->add_option("--tcp", o->tcps, "A board on this TCP port, or ADDRESS:PORT")
      ->allow_extra_args(false);
  command
      ->add_option("--can", o->interfaces,
                   "CAN interface of the --node that follow, or a path: a bus on a socket")
      ->allow_extra_args(false);
  command->add_option("--node", o->nodes, "A board with this number on the CAN bus, 1 to 14")
      ->check(CLI::Range(1, 14))
      ->allow_extra_args(false);
  command->add_flag(
      "--rover", o->rover,
      "A robot with messages of its own on the CAN interface, as examples/rover says");
  auto* raw = command->add_flag("--raw")->description("Replies as bytes from the start [default]");
  command->add_flag("--verbose", o->verbose, "Replies as text until O 0")->excludes(raw);
  auto* msb = command->add_flag("--msb")->description("Most significant byte first [default]");
  command->add_flag("--lsb", o->lsb, "Least significant byte first")->excludes(msb);
  command->add_flag("--binary", o->binary, "Requests are a letter and bytes, not lines of text");
  command->add_flag("--prompt", o->prompt, "Shows > after text");
  command->add_flag("!--no-vw", o->vw, "Without the v-omega letters");
  command->add_flag("--fd", o->fd, "CAN FD frames for the LIDAR");
  command->add_option("--ids", o->ids, "Bits of a CAN identifier, 11 or 29 [11]")
      ->check(CLI::IsMember({11, 29}))
      ->needs("--can");
  command->add_option("--offset", o->offset, "Is added to each CAN identifier [0]")
      ->check(CLI::Range(0U, 0x1FFFF800U))
      ->needs("--can");
  command
      ->add_option("--silence", o->silence_ms, "Milliseconds of silence that stop the motors [300]")
      ->check(CLI::Range(10, 60'000));
  command->add_option("--trace", o->trace, "Writes down all bytes and frames")->type_name("FILE");
  command->add_option("--path", o->path, "Writes down where the robots really are (CSV)")
      ->type_name("FILE");
  command->add_flag("--cortex-m3", o->cortex_m3,
                    "On an emulated microcontroller (mps2-an385, qemu-system-arm): one board");
  command->add_option("--elf", o->elf, "Its firmware [eyebridge-mps2.elf of this build]")
      ->type_name("FILE");
  command->add_flag("--hdt", o->hdt, "Prints the robot's HDT file and ends");
  command->footer("The first board drives the world's first robot, the next one the second.");
  command->callback([command, o, &code] { code = run_firmware(*command, *o); });
}

}  // namespace eyebridge::apps
