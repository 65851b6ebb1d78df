#pragma once

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace eyebridge::testing {

/// A run in a room of 3 x 3 m that other commands add robots to or remove them from.
class ChangingRun : public ::testing::TestWithParam<const char*> {
 protected:
  ChangingRun() {
    folder_.write("room.wld",
                  "floor 3000 3000\n0 0 3000 0\n3000 0 3000 3000\n3000 3000 0 3000\n0 3000 0 0\n");
  }
  /// Compiles NAME.c to NAME.
  void build(const std::string& names) const {
    const auto built = run_shell(
        "for p in " + names + "; do eyebridge-cc $p.c -o $p || exit 1; done", folder_.path());
    EXPECT_EQ(built.exit_code, 0) << built.err;
  }
  /// Sockets of runs lie in the folder: no other run is found.
  [[nodiscard]] std::map<std::string, std::string> own_place() const {
    return {{"XDG_RUNTIME_DIR", folder_.path()}, {"XDG_CONFIG_HOME", "/dev/null/none"}};
  }
  [[nodiscard]] ProgramRun ask(const std::vector<std::string>& words) const {
    return run_command(words, folder_.path(), own_place());
  }
  /// What a command says that must fail.
  [[nodiscard]] std::string error(const std::vector<std::string>& words) const {
    const auto r = ask(words);
    EXPECT_NE(r.exit_code, 0);
    EXPECT_EQ(r.out, "");
    return r.err;
  }

  ScratchFolder folder_;
  std::string sim_;
};

}  // namespace eyebridge::testing
