#include "remote_robot/remote_clock.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "remote_robot/robot_line.hpp"

namespace eyebridge::hal {
namespace {

/// Runs by itself up to the limit that the server gave; beyond, the server lets it go on.
class VirtualRemoteClock final : public Clock {
 public:
  explicit VirtualRemoteClock(RobotLine& line) : line_(line) {}

  [[nodiscard]] Time now() const override { return line_.now(); }
  void wait_until(Time deadline) override { line_.advance_to(deadline); }
  void spend(Time cost) override { line_.spend(cost); }
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  RobotLine& line_;
};

/// Asks what time it is: the world's may slip, and stands still at first. Who waits sleeps here, so
/// that other threads can ask meanwhile.
class RealRemoteClock final : public Clock {
 public:
  RealRemoteClock(RobotLine& line, double factor) : line_(line), factor_(factor) {}

  [[nodiscard]] Time now() const override { return line_.ask_now(); }
  [[nodiscard]] Time at(Time moment) const override {
    const Time age = std::chrono::steady_clock::now().time_since_epoch() - moment;
    return line_.ask_now() - std::chrono::duration_cast<Time>(factor_ * age);
  }
  void wait_until(Time deadline) override {
    constexpr std::chrono::duration<double, std::nano> kShortest{100e3};
    for (Time now = line_.ask_now(); now < deadline; now = line_.ask_now()) {
      const std::chrono::duration<double, std::nano> left = (deadline - now) / factor_;
      // Not sleep_for(): the library's own nanosleep() would ask this clock.
      std::mutex mutex;
      std::unique_lock lock(mutex);
      std::condition_variable().wait_for(lock, std::max(left, kShortest));
      if (line_.is_lost()) return;
    }
  }
  void spend(Time) override {}
  [[nodiscard]] bool is_virtual() const override { return false; }

 private:
  RobotLine& line_;
  const double factor_;
};

}  // namespace

std::unique_ptr<Clock> make_remote_clock(RobotLine& line, bool is_virtual, double factor) {
  if (is_virtual) return std::make_unique<VirtualRemoteClock>(line);
  return std::make_unique<RealRemoteClock>(line, factor);
}

}  // namespace eyebridge::hal
