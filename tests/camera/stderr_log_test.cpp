#include "sources/stderr_log.hpp"

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "eyebridge/base/log.hpp"
#include "fake_view.hpp"

namespace eyebridge::camera::testing {
namespace {

/// What a source without a log shows of `message`.
std::string shown(Severity severity, std::string_view message) {
  ::testing::internal::CaptureStderr();
  log_or_stderr(nullptr).write(severity, message);
  return ::testing::internal::GetCapturedStderr();
}

TEST(StderrLog, ShowsWarningsAndErrorsAndNothingElse) {
  EXPECT_EQ(shown(Severity::Error, "no camera"), "eyebridge: error: no camera\n");
  EXPECT_EQ(shown(Severity::Warning, "a dark one"), "eyebridge: warning: a dark one\n");
  EXPECT_EQ(shown(Severity::Info, "a bright one"), "");
}

TEST(StderrLog, IsNotUsedWhereThereIsALog) {
  RecordingLog log;
  EXPECT_EQ(&log_or_stderr(&log), &log);
}

}  // namespace
}  // namespace eyebridge::camera::testing
