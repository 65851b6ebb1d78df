#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "eb_config.h"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/files/scenario.hpp"
#include "eyebridge/pins/board_world.hpp"
#include "eyebridge/ports/lines.hpp"
#include "eyebridge/ports/trace.hpp"
#include "output_file.hpp"

namespace CLI {
class App;
}

namespace eyebridge::apps {

// What `eyebridge firmware` has for boards of both kinds: those in its own process, and the one on
// an emulated microcontroller.

/// What the command line said.
struct FirmwareOptions {
  std::string world;
  std::string robot = "S4";
  std::vector<std::string> ptys, tcps;
  std::vector<std::string> interfaces;
  std::vector<int> nodes;
  std::string trace, path;
  std::string elf;  ///< "" is our own.
  bool cortex_m3 = false;
  bool hdt = false, fd = false, rover = false;
  int ids = 11;              ///< Bits of a CAN identifier.
  std::uint32_t offset = 0;  ///< Of all CAN identifiers.
  bool verbose = false, lsb = false, binary = false;
  bool vw = true, prompt = false;
  int silence_ms = 300;
};

/// A board that was asked for.
struct WantedBoard {
  enum class Kind { Pty, Tcp, Can, Rover } kind{};
  std::string name;
  int node = 0;  ///< Of Can.
};

/// In the order of the command line; at least one. Throws ConfigError.
std::vector<WantedBoard> wanted_boards(const CLI::App& command, const FirmwareOptions& options);
eb_config board_config(const FirmwareOptions& options, const WantedBoard& wanted);

/// The computer's clock, which only goes forward.
Time monotonic_now();

/// Where `--trace` goes, if it was given; times count from its making.
class FirmwareTrace {
 public:
  /// Throws ConfigError when the file cannot be written.
  explicit FirmwareTrace(const std::string& path);
  ports::ByteLine traced(const ports::ByteLine& line) const;
  ports::FrameLine traced(const ports::FrameLine& line, const std::string& name) const;

 private:
  [[nodiscard]] ports::TraceSink sink() const;
  [[nodiscard]] ports::Now clock() const;
  OutputFile file_;
  Time start_;
};

/// A line of bytes on a pseudo-terminal or TCP. Throws ConfigError.
std::unique_ptr<ports::Port> open_byte_port(const ports::ByteLine& line, const WantedBoard& wanted);

/// What is told when all boards are there, and at the end: where their robots really are.
void print_start(const std::vector<std::unique_ptr<ports::Port>>& ports, const std::string& world);
void print_end(Time run, pins::BoardWorld& world, std::size_t boards);

/// Runs the one board that was asked for on an emulated Cortex-M3, until a signal comes; returns
/// the exit code. Throws ConfigError.
int run_emulated(const FirmwareOptions& options, const files::Scenario& scenario,
                 const std::vector<WantedBoard>& wanted);

}  // namespace eyebridge::apps
