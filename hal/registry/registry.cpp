#include "eyebridge/hal/registry.hpp"

#include <algorithm>
#include <array>
#include <fstream>

#include <fmt/format.h>

#include "board/open_board.hpp"
#include "eyebridge/base/text.hpp"
#include "fault/fault_tap.hpp"
#include "replay/open_replay.hpp"
#include "replay/record_tap.hpp"
#include "sim/open_sim.hpp"

namespace eyebridge::hal {
namespace {

constexpr auto kBackends = std::to_array<BackendFactory>({
    {"sim", "a simulated robot in the world that --world names", open_sim},
    {"serial", "a board on a serial port: serial:/dev/ttyACM0?profile=io7&baud=115200&hdt=FILE",
     open_io7_board, true},
    {"tcp", "a board behind a TCP port: tcp:HOST:PORT?profile=io7&hdt=FILE", open_io7_board, true},
    {"can", "a robot on a CAN bus: can:can0?node=1&fd=0&hdt=FILE", open_can_board, true},
    {"replay", "what a robot answered in a recorded run: replay:FILE.ebrec", open_replay},
});

FaultScript faults_of(const Config& config) {
  const ConfigValue& value = config.value("faults");
  try {
    return parse_fault_script(value.text, {});
  } catch (const ConfigError& error) {
    throw error_in(value, error);
  }
}

/// How this process was started, its words between blanks.
std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string line(4096, '\0');
  file.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(file.gcount()));
  std::ranges::replace(line, '\0', ' ');
  return std::string(trimmed(line));
}

std::unique_ptr<Backend> recorded(std::unique_ptr<Backend> backend, const BackendContext& context) {
  const ConfigValue& record = context.config.value("record");
  try {
    const Config& config = context.config;
    return with_recording(std::move(backend), config.path("record"), context.log,
                          {command_line(), config.text("hal"), config.text("world")});
  } catch (const ConfigError& error) {
    throw error_in(record, error);
  }
}

}  // namespace

std::span<const BackendFactory> backend_table() { return kBackends; }

const BackendFactory& find_backend(const Config& config) {
  const ConfigValue& hal = config.value("hal");
  const BackendUrl url = parse_backend_url(hal.text, hal.where);
  const auto* row = std::ranges::find(kBackends, url.scheme, &BackendFactory::scheme);
  if (row != kBackends.end()) {
    static_cast<void>(faults_of(config));
    return *row;
  }

  std::string known;
  for (const BackendFactory& backend : kBackends) {
    known += known.empty() ? "" : ", ";
    known += backend.scheme;
  }
  throw ConfigError(hal.where,
                    fmt::format("unknown backend '{}', expected one of: {}", url.scheme, known));
}

std::unique_ptr<Backend> open_backend(const BackendContext& context) {
  const Config& config = context.config;
  const ConfigValue& hal = config.value("hal");
  FaultScript script = faults_of(config);
  auto backend = find_backend(config).open(parse_backend_url(hal.text, hal.where), context);
  if (!script.empty()) {
    const auto seed = static_cast<std::uint64_t>(config.integer("seed"));
    backend = with_faults(std::move(backend), std::move(script), seed);
  }
  // Outermost: what the program sees.
  if (config.is_set("record")) backend = recorded(std::move(backend), context);
  return backend;
}

}  // namespace eyebridge::hal
