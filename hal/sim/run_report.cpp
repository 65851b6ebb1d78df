#include "sim/run_report.hpp"

#include <array>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_results.hpp"

namespace eyebridge::hal {
namespace {

constexpr double kPeriod = 1.0;  // seconds of the robot's time
constexpr std::size_t kLongestName = 32;

/// Opens it, emptied, if it may be replaced.
UniqueFd open_report(const std::filesystem::path& path) {
  check_replaceable(path, "report", "time =     ");
  return UniqueFd(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
}

}  // namespace

RunReport::RunReport(const std::filesystem::path& path) : path_(path), file_(open_report(path)) {
  if (!file_.valid()) {
    throw ConfigError({}, fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
  }
}

void RunReport::step(const robot::Simulation& simulation, std::uint64_t trace) {
  tally_.add_step(simulation);
  if (simulation.time() < next_) return;
  next_ = simulation.time() + kPeriod;
  write(simulation, trace, false);
}

void RunReport::note(const std::string& name, double value) {
  assert(!name.empty() && name.size() <= kLongestName && std::isfinite(value));
  notes_[name] = value;
  assert(notes_.size() <= kMostNotes);
}

std::string RunReport::lost() const {
  if (failure_ == 0 && is_still_at(path_, file_.get())) return {};
  return fmt::format("the report {} could not be written: {}", path_.string(),
                     failure_ == 0 ? kRemoved : std::strerror(failure_));
}

// No text is shorter than the one before, so that one write replaces that one whole. A disk that is
// full must not stop a robot: that is said at the end.
void RunReport::write(const robot::Simulation& simulation, std::uint64_t trace,
                      bool ended) noexcept {
  std::array<char, 512 + kMostNotes*(kLongestName + 24)> text{};
  char* end = text.data();
  const auto left = [&] { return static_cast<std::size_t>(text.data() + text.size() - end); };
  end = fmt::format_to_n(
            end, left(),
            "time = {:18.6f}\ndistance = {:18.6f}\ncollisions = {:18}\nstuck = {:18.6f}\n"
            "state_hash = \"{:016x}\"\ntrace_hash = \"{:016x}\"\nended = {:5}\n",
            simulation.time(), tally_.distance(), tally_.collisions(), tally_.longest_stuck(),
            simulation.state_hash(), trace, ended)
            .out;
  if (simulation.robot_count() > 0) {
    const Pose pose = simulation.pose(0);
    end =
        fmt::format_to_n(end, left(), "end_x = {:18.6f}\nend_y = {:18.6f}\nend_theta = {:18.6f}\n",
                         pose.x, pose.y, pose.theta)
            .out;
    if (const auto depth = simulation.depth(0)) {
      end = fmt::format_to_n(end, left(), "end_depth = {:18.6f}\n", *depth).out;
    }
  }
  for (const auto& [name, value] : notes_) {
    end = fmt::format_to_n(end, left(), "{} = {:18.6f}\n", name, value).out;
  }
  const auto size = static_cast<std::size_t>(end - text.data());
  const ssize_t written = pwrite(file_.get(), text.data(), size, 0);
  failure_ = written < 0 ? errno : static_cast<std::size_t>(written) < size ? ENOSPC : 0;
}

}  // namespace eyebridge::hal
