#include "firmware_process.hpp"

#include <csignal>
#include <cstdio>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge::testing {

FirmwareProcess::FirmwareProcess(const std::vector<std::string>& options) {
  int ends[2] = {-1, -1};
  EXPECT_EQ(pipe(ends), 0);
  pid_ = fork();
  if (pid_ == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    std::vector<std::string> words = {EYEBRIDGE_BIN "/eyebridge", "firmware", "--world",
                                      EYEBRIDGE_WORLD};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  close(ends[1]);
  output_ = ends[0];
  // "robot 1: eyebridge run --hal URL PROGRAM", then one line about all.
  const std::string first = line();
  const std::string before = "--hal ";
  const std::size_t begin = first.find(before);
  EXPECT_NE(begin, std::string::npos) << first;
  if (begin == std::string::npos) return;
  hal_ = first.substr(begin + before.size());
  hal_ = hal_.substr(0, hal_.find(' '));
  line();
}

FirmwareProcess::~FirmwareProcess() {
  if (pid_ > 0) stop();
  close(output_);
}

std::string FirmwareProcess::line() const {
  std::string text;
  char c = 0;
  while (read(output_, &c, 1) == 1 && c != '\n') text += c;
  return text;
}

Pose FirmwareProcess::stop() {
  kill(pid_, SIGTERM);
  double x = 0;
  double y = 0;
  double degrees = 0;
  bool found = false;
  for (std::string text = line(); !text.empty(); text = line()) {
    found |=
        std::sscanf(text.c_str(), "robot 1 at %lf mm %lf mm %lf degrees", &x, &y, &degrees) == 3;
  }
  EXPECT_TRUE(found) << "the firmware did not say where its robot is";
  EXPECT_EQ(waitpid(pid_, nullptr, 0), pid_);
  pid_ = -1;
  return {mm_to_m(x), mm_to_m(y), deg_to_rad(degrees)};
}

}  // namespace eyebridge::testing
