#include "sweep/run_cells.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <exception>
#include <memory>
#include <system_error>

#include <poll.h>

#include "sweep/cell_process.hpp"

namespace eyebridge::apps {
namespace {

constexpr auto kLookPeriod = std::chrono::milliseconds(200);  // for stop()

struct Running {
  std::size_t cell = 0;
  std::unique_ptr<CellProcess> process;
};

/// Waits until one of `running` has ended or wants to be looked after.
std::vector<pollfd> wait_for(const std::vector<Running>& running) {
  std::vector<pollfd> ends;
  auto until = std::chrono::steady_clock::now() + kLookPeriod;
  for (const Running& run : running) {
    ends.push_back({run.process->descriptor(), POLLIN, 0});
    until = std::min(until, run.process->due());
  }
  const auto left =
      std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
  const int wait = static_cast<int>(std::max(left.count(), std::chrono::milliseconds::rep{0}));
  if (poll(ends.data(), ends.size(), wait) < 0 && errno != EINTR) {
    throw std::system_error(errno, std::generic_category(), "waiting for runs");
  }
  return ends;
}

}  // namespace

bool run_cells(const std::vector<Cell>& cells, std::span<const std::size_t> todo,
               const RunSettings& settings,
               const std::function<void(std::size_t, const Outcome&)>& ended,
               const std::function<bool()>& stop) {
  std::vector<Running> running;
  const auto start = [&] {
    while (!todo.empty() && running.size() < static_cast<std::size_t>(settings.jobs)) {
      const std::size_t cell = todo.front();
      todo = todo.subspan(1);
      running.push_back({cell, std::make_unique<CellProcess>(cells[cell], cell + 1, settings)});
    }
  };
  while (!todo.empty() || !running.empty()) {
    if (stop()) return false;
    start();
    const std::vector<pollfd> ends = wait_for(running);
    const auto now = std::chrono::steady_clock::now();
    std::vector<Running> over;
    for (std::size_t i = running.size(); i-- > 0;) {
      if (ends[i].revents == 0) {
        running[i].process->check_time(now);
        continue;
      }
      over.push_back(std::move(running[i]));
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
    }
    // Storing results takes a while: the next runs start before.
    std::exception_ptr failure;
    try {
      start();
    } catch (...) {
      failure = std::current_exception();
    }
    for (const Running& run : over) ended(run.cell, run.process->reap());
    if (failure) std::rethrow_exception(failure);
  }
  return true;
}

}  // namespace eyebridge::apps
