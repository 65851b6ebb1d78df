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

}  // namespace eyebridge::testing
