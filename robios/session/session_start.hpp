#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/shared_world.hpp"

namespace eyebridge::robios {

/// Who runs the program of one of several robots: what the session asks of it.
class Runner {
 public:
  virtual ~Runner() = default;

  /// Ends the robot's program with this exit code, from one of its threads. Does not return.
  [[noreturn]] virtual void leave(int code) = 0;
  /// The program makes its first call: returns when those of all robots have.
  virtual void arrive() = 0;
  /// A thread of the robot goes on calling after its end: it never gets further.
  [[noreturn]] virtual void hold_thread() = 0;
  /// Where the program has its copy of the library's variable `name`; null when it has none.
  virtual void* variable(const char* name) = 0;
};

/// How the session of one of several robots begins.
struct SessionStart {
  hal::Config config;
  hal::WorldSlot slot;
  Runner* runner = nullptr;        ///< Lent.
  std::string name;                ///< Before its messages: "robot 2".
  std::filesystem::path out = {};  ///< Of its results; empty when none are wanted.
};

}  // namespace eyebridge::robios
