#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "arrivals.hpp"
#include "control_server.hpp"
#include "hold_up.hpp"
#include "joining.hpp"
#include "log/stderr_log.hpp"
#include "program_process.hpp"
#include "watchdog.hpp"

namespace eyebridge::robios {

/// Each program in a process of its own, which a thread here answers. In virtual time these threads
/// take turns with the first robot's program: it waits at each step until the others have come
/// there.
class JoinedRobots final : public Joining, private hal::JoiningTurns {
 public:
  explicit JoinedRobots(const hal::Config& config);

  hal::JoiningTurns& turns() override { return *this; }
  void open(std::shared_ptr<hal::SharedWorld> world) override;
  void look() override;
  [[nodiscard]] bool is_busy() const override { return has_any(); }
  [[nodiscard]] bool is_awaited() const override { return awaited_ != nullptr; }
  int await_end() override;
  void end() noexcept override;

  Result<std::size_t> add(const Words& words) override;
  Result<void> remove(std::size_t index) override;

 private:
  struct Joined {
    explicit Joined(std::size_t its_index, Time now) : index(its_index), limit(now), wanted(now) {}
    const std::size_t index;
    Time limit;               ///< Of its clock, in virtual time.
    Time wanted;              ///< Where it goes on.
    bool has_turn = false;    ///< It runs, and the first robot waits.
    bool is_leaving = false;  ///< It waits for nobody any more.
    bool has_started = false;
    bool has_ended = false;
    int exit_code = 0;
    std::unique_ptr<ProgramProcess> process;
  };

  [[nodiscard]] const Time& limit_of(std::size_t robot) const override;
  void wait(std::size_t robot, Time time) override;
  void before_step(Time end) override;
  void after_step() override { arrivals_.serve(); }

  /// In virtual time: between two steps.
  Result<std::size_t> change(Arrivals::Act act);
  Result<std::size_t> enter(const hal::Newcomer& newcomer);
  Result<std::size_t> leave(std::size_t index);
  void start(std::size_t index, RobotProgram program);
  void run(Joined& robot);
  /// One less runs, with this exit code.
  void finish(Joined& robot, int code);
  /// Ends the programs of `robots`; returns when they have ended.
  void end_programs(const std::vector<Joined*>& robots) noexcept;
  [[nodiscard]] std::vector<Joined*> all() const;
  [[nodiscard]] Joined* find(std::size_t index) const;  ///< mutex_ is held.
  void tell_of_hang(double seconds) const;

  const hal::Config config_;
  const bool is_virtual_;
  StderrLog log_;
  std::shared_ptr<hal::SharedWorld> world_;
  std::optional<ControlServer> control_;
  Arrivals arrivals_;  ///< In virtual time.

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::unique_ptr<Joined>> robots_;  ///< In the order of their numbers; never fewer.
  bool is_closed_ = false;                       ///< The last program has ended.
  bool is_interrupted_ = false;                  ///< A signal ends the process.
  std::atomic<bool> first_has_ended_ = false;
  std::mutex changing_;  ///< In real time: one robot at a time enters or leaves.

  AwaitedProcess awaited_ = nullptr;
  std::atomic<std::uint64_t> turns_taken_ = 0;
  HoldUp hold_up_;
  double waited_s_ = 0.0;
  Watchdog watchdog_;
  Watchdog waiting_;
};

}  // namespace eyebridge::robios
