#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <poll.h>

#include "command.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/pins/board_world.hpp"
#include "eyebridge/pins/psd_table.hpp"
#include "eyebridge/ports/can_hub.hpp"
#include "eyebridge/ports/lines.hpp"
#include "eyebridge/ports/trace.hpp"
#include "path_file.hpp"

namespace eyebridge::apps {
namespace {

/// What the command line said.
struct FirmwareOptions {
  std::string world;
  std::string robot = "S4";
  std::vector<std::string> ptys, tcps;
  std::vector<std::string> interfaces;
  std::vector<int> nodes;
  std::string trace, path;
  bool hdt = false, fd = false;
  bool verbose = false, raw = false, msb = false, lsb = false, binary = false;
  bool vw = true, prompt = false;
  int silence_ms = 300;
};

/// A board that was asked for, in the order of the command line.
struct Wanted {
  enum class Kind { Pty, Tcp, Can } kind{};
  std::string name;
  int node = 0;
};

volatile std::sig_atomic_t stop_asked = 0;

void ask_to_stop(int) { stop_asked = 1; }

void stop_on_signals() {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

Time monotonic_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

std::vector<Wanted> wanted_boards(const CLI::App& command, const FirmwareOptions& options) {
  std::vector<Wanted> wanted;
  std::size_t pty = 0;
  std::size_t tcp = 0;
  std::size_t node = 0;
  if (options.interfaces.size() > 1 && options.interfaces.size() != options.nodes.size()) {
    throw ConfigError({"--can"}, fmt::format("found {} interfaces for {} nodes, expected one, or "
                                             "one for each node",
                                             options.interfaces.size(), options.nodes.size()));
  }
  for (const CLI::Option* option : command.parse_order()) {
    if (option->check_lname("pty")) {
      wanted.push_back({Wanted::Kind::Pty, options.ptys.at(pty++), 0});
    } else if (option->check_lname("tcp")) {
      wanted.push_back({Wanted::Kind::Tcp, options.tcps.at(tcp++), 0});
    } else if (option->check_lname("node")) {
      const auto& names = options.interfaces;
      if (names.empty()) throw ConfigError({"--node"}, "found no --can, expected its interface");
      wanted.push_back({Wanted::Kind::Can, names.size() == 1 ? names[0] : names.at(node),
                        options.nodes.at(node)});
      ++node;
    }
  }
  if (!options.interfaces.empty() && options.nodes.empty()) {
    throw ConfigError({"--can"}, "found no --node, expected a number 1 to 14");
  }
  if (wanted.empty())
    throw ConfigError({"firmware"}, "found no board, expected --pty, --tcp or --can");
  return wanted;
}

eb_config board_config(const FirmwareOptions& options, const Wanted& wanted) {
  eb_config config;
  eb_config_default(&config);
  config.io7.binary = options.binary;
  config.io7.verbose = options.verbose;
  config.io7.lsb_first = options.lsb;
  config.io7.letters = options.vw ? EB_LETTERS_ALL : EB_LETTERS_PAGE;
  if (options.prompt) config.io7.prompt[0] = '>';
  config.silence_us = static_cast<std::uint32_t>(options.silence_ms) * 1000U;
  config.node = static_cast<std::uint8_t>(wanted.node);
  config.can_fd = options.fd;
  return config;
}

using TraceFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Runs the boards until a signal comes.
class FirmwareRun {
 public:
  FirmwareRun(const FirmwareOptions& options, const files::Scenario& scenario)
      : options_(options), world_(scenario), start_(monotonic_now()) {}

  void open(const std::vector<Wanted>& wanted) {
    if (wanted.size() > world_.robots()) {
      throw ConfigError({options_.world},
                        fmt::format("found {} robot(s), expected one for each of {} boards",
                                    world_.robots(), wanted.size()));
    }
    if (!options_.trace.empty()) open_trace();
    if (!options_.path.empty()) path_.emplace(options_.path);
    serve_buses(wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      eb_board& board =
          world_.add_board(static_cast<robot::RobotIndex>(i), board_config(options_, wanted[i]));
      ports_.push_back(open_port(board, wanted[i]));
      std::printf("robot %zu: eyebridge run --hal %s PROGRAM\n", i + 1,
                  ports_.back()->address().c_str());
    }
    std::printf("%zu board(s) in %s; Ctrl-C ends\n", ports_.size(), options_.world.c_str());
    std::fflush(stdout);
  }

  void run() {
    while (stop_asked == 0) {
      const Time due = world_.advance(now());
      if (path_) path_->note(now(), world_.simulation(), ports_.size());
      pump();
      wait(due);
      pump();
    }
    std::printf("stopped after %.1f s\n", to_seconds(now()));
    for (std::size_t i = 0; i < ports_.size(); ++i) {
      const Pose pose = world_.simulation().pose(static_cast<robot::RobotIndex>(i));
      std::printf("robot %zu at %.1f mm %.1f mm %.2f degrees\n", i + 1, m_to_mm(pose.x),
                  m_to_mm(pose.y), rad_to_deg(pose.theta));
    }
  }

 private:
  [[nodiscard]] Time now() const { return monotonic_now() - start_; }

  void open_trace() {
    trace_.reset(std::fopen(options_.trace.c_str(), "we"));
    if (trace_ == nullptr) throw ConfigError({"--trace"}, "cannot write " + options_.trace);
    std::setvbuf(trace_.get(), nullptr, _IOLBF, BUFSIZ);
  }

  /// A bus on a socket is served by the first process that names it.
  void serve_buses(const std::vector<Wanted>& wanted) {
    for (const Wanted& board : wanted) {
      if (board.kind != Wanted::Kind::Can || !ports::is_can_path(board.name)) continue;
      if (auto hub = ports::open_can_hub(board.name, {"--can"})) hubs_.push_back(std::move(hub));
    }
  }

  std::unique_ptr<ports::Port> open_port(eb_board& board, const Wanted& wanted) {
    const auto sink = [file = trace_.get()](std::string_view line) {
      std::fprintf(file, "%.*s\n", static_cast<int>(line.size()), line.data());
    };
    const auto clock = [start = start_] { return monotonic_now() - start; };
    if (wanted.kind == Wanted::Kind::Can) {
      ports::FrameLine line = ports::frame_line(board);
      if (trace_) line = ports::traced(line, wanted.name, sink, clock);
      return ports::open_can(line, wanted.name, options_.fd, wanted.node, {"--can"});
    }
    ports::ByteLine line = ports::byte_line(board);
    if (trace_) line = ports::traced(line, sink, clock);
    if (wanted.kind == Wanted::Kind::Tcp) return ports::open_tcp(line, wanted.name, {"--tcp"});
    return ports::open_pty(line, wanted.name, {"--pty"});
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
  TraceFile trace_{nullptr, &std::fclose};
  std::optional<PathFile> path_;
  std::vector<std::unique_ptr<ports::Port>> hubs_;
  std::vector<std::unique_ptr<ports::Port>> ports_;
  std::vector<pollfd> polled_;
};

int run_firmware(const CLI::App& command, const FirmwareOptions& options) {
  const files::Scenario scenario =
      files::load_scenario(options.world, options.robot, {}, {"--robot"});
  for (const Warning& warning : scenario.warnings) {
    std::fprintf(stderr, "eyebridge: %s\n", warning.str().c_str());
  }
  if (scenario.robots.empty()) {
    throw ConfigError({options.world}, "found no robot, expected at least one");
  }
  if (options.hdt) {
    std::fputs(pins::hdt_text(scenario.models.at(scenario.robots.front().model)).c_str(), stdout);
    return kFine;
  }
  const std::vector<Wanted> wanted = wanted_boards(command, options);
  try {
    FirmwareRun run(options, scenario);
    stop_on_signals();
    run.open(wanted);
    run.run();
  } catch (const std::invalid_argument& error) {
    throw ConfigError({options.world}, error.what());
  }
  return kFine;
}

}  // namespace

void add_firmware(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand(
      "firmware", "Runs EyeBot I/O boards that drive the robots of a simulated world");
  auto o = std::make_shared<FirmwareOptions>();
  command->add_option("--world", o->world, "World, maze or scenario file")->required();
  command->add_option("--robot", o->robot, "Robot of a world that has none [S4]");
  command->add_option("--pty", o->ptys, "A board on a pseudo-terminal with this name")
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
  auto* raw = command->add_flag("--raw", o->raw, "Replies as bytes from the start [default]");
  command->add_flag("--verbose", o->verbose, "Replies as text until O 0")->excludes(raw);
  auto* msb = command->add_flag("--msb", o->msb, "Most significant byte first [default]");
  command->add_flag("--lsb", o->lsb, "Least significant byte first")->excludes(msb);
  command->add_flag("--binary", o->binary, "Requests are a letter and bytes, not lines of text");
  command->add_flag("--prompt", o->prompt, "Shows > after text");
  command->add_flag("!--no-vw", o->vw, "Without the v-omega letters");
  command->add_flag("--fd", o->fd, "CAN FD frames for the LIDAR");
  command
      ->add_option("--silence", o->silence_ms, "Milliseconds of silence that stop the motors [300]")
      ->check(CLI::Range(10, 60'000));
  command->add_option("--trace", o->trace, "Writes down all bytes and frames");
  command->add_option("--path", o->path, "Writes down where the robots really are (CSV)");
  command->add_flag("--hdt", o->hdt, "Prints the robot's HDT file and ends");
  command->footer("The first board drives the world's first robot, the next one the second.");
  command->callback([command, o, &code] { code = run_firmware(*command, *o); });
}

}  // namespace eyebridge::apps
