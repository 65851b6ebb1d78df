#include "sim/run_report.hpp"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {
namespace {

constexpr double kPeriod = 1.0;  // seconds of the robot's time

}  // namespace

RunReport::RunReport(const std::filesystem::path& path)
    : file_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (!file_.valid()) {
    throw ConfigError({}, fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
  }
}

void RunReport::step(const robot::Simulation& simulation) {
  tally_.add_step(simulation);
  if (simulation.time() < next_) return;
  next_ = simulation.time() + kPeriod;
  write(simulation, false);
}

// All texts are of one length, so that one write replaces the last one whole. A disk that is full
// must not stop a robot: whoever reads the report finds none.
void RunReport::write(const robot::Simulation& simulation, bool ended) noexcept {
  std::array<char, 256> text{};
  const auto end = fmt::format_to_n(text.data(), text.size(),
                                    "time = {:18.6f}\ndistance = {:18.6f}\ncollisions = {:18}\n"
                                    "state_hash = \"{:016x}\"\nended = {:5}\n",
                                    simulation.time(), tally_.distance(), tally_.collisions(),
                                    simulation.state_hash(), ended);
  [[maybe_unused]] const ssize_t written = pwrite(file_.get(), text.data(), end.size, 0);
}

}  // namespace eyebridge::hal
