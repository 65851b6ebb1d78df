#pragma once

#include <map>
#include <string>

#include "run_program.hpp"

namespace eyebridge::testing {

/// Runs a program of tests/robios/programs, in virtual time unless `settings` say otherwise.
inline ProgramRun run_named(const std::string& name,
                            std::map<std::string, std::string> settings = {}) {
  settings.emplace("EYEBRIDGE_FAST", "true");
  return run_program({{std::string(EYEBRIDGE_TEST_PROGRAMS) + "/" + name}, settings, ""});
}

/// ASAN_OPTIONS with which a crash ends a process as without the sanitizer.
inline constexpr const char* kCrashesAreTheKernels =
    "handle_segv=0:handle_sigbus=0:handle_abort=0:handle_sigfpe=0:detect_leaks=0:"
    "intercept_tls_get_addr=0";

/// How often to run what must always give the same. A run takes twenty times as long under a
/// sanitizer: there it is `sanitized` times.
inline constexpr int repeats(int count, [[maybe_unused]] int sanitized = 2) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  count = sanitized;
#endif
  return count;
}

/// Both clocks; the settings of a real-time run that does not keep a person waiting.
inline const std::map<std::string, std::string> kClocks[] = {
    {{"EYEBRIDGE_FAST", "true"}}, {{"EYEBRIDGE_FAST", "false"}, {"EYEBRIDGE_FACTOR", "20"}}};

}  // namespace eyebridge::testing
