#pragma once

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "command.hpp"

namespace eyebridge::testing {

/// A folder for a command that runs a program many times.
class ManyRuns : public ::testing::Test {
 protected:
  void write_program(const std::string& name, const std::string& text) {
    chmod(folder_.write(name, text).c_str(), 0755);
  }
  /// Nothing may have been started (a program would say so by a file), and one line says why.
  void expect_refused(const ProgramRun& r, const std::string& message) {
    EXPECT_EQ(r.exit_code, 2) << r.err;
    EXPECT_THAT(r.err, ::testing::HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() + "/started"));
  }

  ScratchFolder folder_;
};

}  // namespace eyebridge::testing
