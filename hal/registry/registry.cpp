#include "eyebridge/hal/registry.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "board/open_board.hpp"
#include "sim/open_sim.hpp"

namespace eyebridge::hal {
namespace {

constexpr auto kBackends = std::to_array<BackendFactory>({
    {"sim", "a simulated robot in the world that --world names", open_sim},
    {"serial", "a board on a serial port: serial:/dev/ttyACM0?profile=io7&baud=115200&hdt=FILE",
     open_io7_board, true},
    {"tcp", "a board behind a TCP port: tcp:HOST:PORT?profile=io7&hdt=FILE", open_io7_board, true},
    {"can", "a robot on a CAN bus: can:can0?node=1&fd=0&hdt=FILE", open_can_board, true},
});

}  // namespace

std::span<const BackendFactory> backend_table() { return kBackends; }

const BackendFactory& find_backend(const Config& config) {
  const ConfigValue& hal = config.value("hal");
  const BackendUrl url = parse_backend_url(hal.text, hal.where);
  const auto* row = std::ranges::find(kBackends, url.scheme, &BackendFactory::scheme);
  if (row != kBackends.end()) return *row;

  std::string known;
  for (const BackendFactory& backend : kBackends) {
    known += known.empty() ? "" : ", ";
    known += backend.scheme;
  }
  throw ConfigError(hal.where,
                    fmt::format("unknown backend '{}', expected one of: {}", url.scheme, known));
}

std::unique_ptr<Backend> open_backend(const BackendContext& context) {
  const ConfigValue& hal = context.config.value("hal");
  return find_backend(context.config).open(parse_backend_url(hal.text, hal.where), context);
}

}  // namespace eyebridge::hal
