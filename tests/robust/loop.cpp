#include "loop.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "eyebridge/bridges/monotonic_clock.hpp"

namespace eyebridge::testing {
namespace {

using namespace std::chrono_literals;

constexpr double kStill = 2e-4;  // metres: less is no movement
constexpr double kStanding = 0.5;
constexpr auto kPatience = 10s;

/// Looks 50 times a second until `done`; false when that does not happen.
template <class Done>
bool wait_for(const Done& done) {
  bridges::MonotonicClock clock;
  while (!done()) {
    if (clock.now() > kPatience) return false;
    clock.wait_until(clock.now() + 20ms);
  }
  return true;
}

}  // namespace

Loop::Loop(const Line& line) : line_(line) { start_firmware(); }

void Loop::start_firmware() {
  std::vector<std::string> arguments{"--world", EYEBRIDGE_SOURCE_DIR "/worlds/soccer-field.wld",
                                     "--path", "path.csv"};
  arguments.insert(arguments.end(), line_.options.begin(), line_.options.end());
  firmware_.emplace(arguments, folder_.path());
  url_ = firmware_->hal();
}

void Loop::start_program() {
  program_.emplace(
      ProgramStart{{EYEBRIDGE_BIN "/robust_driver"}, {{"EYEBRIDGE_HAL", url_}}, folder_.path()});
  const std::string said = program_->wait_for("at 5");  // 50 … 59 mm
  if (said.find("at 5") == std::string::npos) throw std::runtime_error("program: " + said);
}

std::vector<Loop::Row> Loop::path() const {
  std::vector<Row> rows;
  const std::string text = file_text(folder_.path() + "/path.csv");
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    Row row;
    if (text.find('\n', at + 1) == std::string::npos ||
        std::sscanf(text.c_str() + at + 1, "%lf,1,%lf,%lf", &row.t, &row.x, &row.y) != 3) {
      break;
    }
    rows.push_back(row);
  }
  return rows;
}

double Loop::time() const {
  const auto rows = path();
  return rows.empty() ? 0.0 : rows.back().t;
}

std::optional<double> Loop::standing_since() const {
  std::optional<double> since;
  wait_for([&] {
    const auto rows = path();
    if (rows.empty()) return false;
    const Row& last = rows.back();
    double still = last.t;
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
      if (std::hypot(row->x - last.x, row->y - last.y) > kStill) break;
      still = row->t;
    }
    if (last.t - still < kStanding) return false;
    since = still;
    return true;
  });
  return since;
}

bool Loop::moves() const {
  return wait_for([&] {
    const auto rows = path();
    return rows.size() > 10 && std::hypot(rows.back().x - rows[rows.size() - 10].x,
                                          rows.back().y - rows[rows.size() - 10].y) > 10 * kStill;
  });
}

}  // namespace eyebridge::testing
