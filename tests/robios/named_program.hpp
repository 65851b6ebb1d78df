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

/// Both clocks; the settings of a real-time run that does not keep a person waiting.
inline const std::map<std::string, std::string> kClocks[] = {
    {{"EYEBRIDGE_FAST", "true"}}, {{"EYEBRIDGE_FAST", "false"}, {"EYEBRIDGE_FACTOR", "20"}}};

}  // namespace eyebridge::testing
