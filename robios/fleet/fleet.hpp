#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "robot.hpp"
#include "stderr_log.hpp"

namespace eyebridge::robios {

class Strands;

/// Several robots in one world, each with its program, from their start to the last one's end.
class Fleet {
 public:
  /// `words` as programs_of() takes them. Throws ConfigError.
  Fleet(hal::Config config, const std::vector<std::string>& words);
  ~Fleet();
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  /// Runs all programs to their end. Returns the first exit code that is not 0, by the robots'
  /// numbers.
  int run();
  /// What the programs' threads wait for each other with; null in real time.
  [[nodiscard]] Strands* strands();
  /// end(), for a signal that ends the process then: run() does not return. Any thread.
  void stop();
  /// Ends every robot's session: motors stop, results are written. Any thread.
  void end();

 private:
  struct Scheduler;
  struct InLockstep;
  struct InRealTime;

  void add_robots(const std::vector<std::string>& words);
  [[nodiscard]] int exit_code() const;

  const hal::Config config_;
  StderrLog log_;
  std::unique_ptr<Scheduler> scheduler_;
  std::shared_ptr<hal::SharedWorld> world_;
  std::vector<std::unique_ptr<Robot>> robots_;  ///< Those with a program.
  std::atomic<bool> is_stopped_ = false;
};

}  // namespace eyebridge::robios
