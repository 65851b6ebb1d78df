#include "firmware_parts.hpp"

#include <cstdio>
#include <ctime>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge::apps {

Time monotonic_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

std::vector<WantedBoard> wanted_boards(const CLI::App& command, const FirmwareOptions& options) {
  using Kind = WantedBoard::Kind;
  std::vector<WantedBoard> wanted;
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
      wanted.push_back({Kind::Pty, options.ptys.at(pty++), 0});
    } else if (option->check_lname("tcp")) {
      wanted.push_back({Kind::Tcp, options.tcps.at(tcp++), 0});
    } else if (option->check_lname("node")) {
      const auto& names = options.interfaces;
      if (names.empty()) throw ConfigError({"--node"}, "found no --can, expected its interface");
      wanted.push_back(
          {Kind::Can, names.size() == 1 ? names[0] : names.at(node), options.nodes.at(node)});
      ++node;
    } else if (option->check_lname("rover")) {
      if (options.interfaces.empty()) {
        throw ConfigError({"--rover"}, "found no --can, expected its interface");
      }
      wanted.push_back({Kind::Rover, options.interfaces[0], 0});
    }
  }
  if (!options.interfaces.empty() && options.nodes.empty() && !options.rover) {
    throw ConfigError({"--can"}, "found no --node, expected a number 1 to 14, or --rover");
  }
  constexpr std::uint32_t kMost11 = 0xF0;  // the highest identifier is 70F, there are 7FF
  if (options.ids == 11 && options.offset > kMost11) {
    throw ConfigError({"--offset"}, fmt::format("found {}, expected 0 to {}, or --ids 29",
                                                options.offset, kMost11));
  }
  if (wanted.empty())
    throw ConfigError({"firmware"}, "found no board, expected --pty, --tcp or --can");
  return wanted;
}

eb_config board_config(const FirmwareOptions& options, const WantedBoard& wanted) {
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

FirmwareTrace::FirmwareTrace(const std::string& path)
    : file_(open_output(path, kTraceOutput)), start_(monotonic_now()) {}

ports::TraceSink FirmwareTrace::sink() const {
  return [file = file_.get()](std::string_view line) {
    std::fprintf(file, "%.*s\n", static_cast<int>(line.size()), line.data());
  };
}

ports::Now FirmwareTrace::clock() const {
  return [start = start_] { return monotonic_now() - start; };
}

ports::ByteLine FirmwareTrace::traced(const ports::ByteLine& line) const {
  return file_ ? ports::traced(line, sink(), clock()) : line;
}

ports::FrameLine FirmwareTrace::traced(const ports::FrameLine& line,
                                       const std::string& name) const {
  return file_ ? ports::traced(line, name, sink(), clock()) : line;
}

std::unique_ptr<ports::Port> open_byte_port(const ports::ByteLine& line,
                                            const WantedBoard& wanted) {
  if (wanted.kind == WantedBoard::Kind::Tcp) return ports::open_tcp(line, wanted.name, {"--tcp"});
  return ports::open_pty(line, wanted.name, {"--pty"});
}

void print_start(const std::vector<std::unique_ptr<ports::Port>>& ports, const std::string& world) {
  for (std::size_t i = 0; i < ports.size(); ++i) {
    const std::string address = ports[i]->address();
    const char* const quote = address.find('&') == std::string::npos ? "" : "'";
    std::printf("robot %zu: eyebridge run --hal %s%s%s PROGRAM\n", i + 1, quote, address.c_str(),
                quote);
  }
  std::printf("%zu board(s) in %s; Ctrl-C ends\n", ports.size(), world.c_str());
  std::fflush(stdout);
}

void print_end(Time run, pins::BoardWorld& world, std::size_t boards) {
  std::printf("stopped after %.1f s\n", to_seconds(run));
  for (std::size_t i = 0; i < boards; ++i) {
    const Pose pose = world.simulation().pose(static_cast<robot::RobotIndex>(i));
    std::printf("robot %zu at %.1f mm %.1f mm %.2f degrees\n", i + 1, m_to_mm(pose.x),
                m_to_mm(pose.y), rad_to_deg(pose.theta));
  }
}

}  // namespace eyebridge::apps
