// The trace of a run is the same whatever else the computer does, and tells runs apart in which
// anything else was seen.
#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "processors.hpp"
#include "several_robots.hpp"

namespace eyebridge {
namespace {

using testing::Processors;
using testing::run_named;
using testing::several;

/// The trace of a run of so many robots in worlds/rooms.wld.
std::string trace_of_run(const std::string& program, const std::string& robots,
                         const std::string& errors = "") {
  const auto r = run_named(program, several(robots, {{"EYEBRIDGE_ERRORS", errors}}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  return testing::trace_of(r.err);
}

/// The same of a robot that is alone, by its report.
std::string trace_alone(const std::string& program) {
  const testing::ScratchFolder folder;
  const std::string report = folder.path() + "/report";
  const auto r = run_named(program, {{"EYEBRIDGE_REPORT", report},
                                     {"EYEBRIDGE_WORLD", EYEBRIDGE_TEST_WORLDS "/rooms.wld"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const std::string text = testing::file_text(report);
  const std::size_t at = text.find("trace_hash = \"");
  return at == std::string::npos ? "" : "trace " + text.substr(at + 14, 16);
}

constexpr int kRuns = testing::repeats(25, 1);

using Loads = std::vector<Processors::Load>;

/// The one trace of as many runs on one processor and on all, each under these loads: another
/// process that keeps all of them busy, or none.
std::string of_runs(int runs, const Loads& loads, const std::function<std::string()>& trace) {
  std::set<std::string> traces;
  for (const auto which : {Processors::Which::First, Processors::Which::All}) {
    for (const auto load : loads) {
      const Processors processors(which, load);
      for (int i = 0; i < runs; ++i) traces.insert(trace());
    }
  }
  EXPECT_EQ(traces.size(), 1U);
  return *traces.begin();
}

std::string of_a_hundred(const std::function<std::string()>& trace) {
  return of_runs(kRuns, {Processors::Load::None, Processors::Load::Busy}, trace);
}

// Whatever the build: these are the same in debug, release and sanitized ones. Five cameras take a
// second of each run to make ready.
TEST(Trace, OfTwentyRunsWithCamerasIsOne) {
  EXPECT_EQ(of_runs(std::min(kRuns, 5), {Processors::Load::None, Processors::Load::Busy},
                    [] { return trace_of_run("several", "5"); }),
            "trace d0f500bbb6022b41");
}

TEST(Trace, OfAHundredRunsWithThreadsOfTheSystemIsOne) {
  EXPECT_EQ(of_a_hundred([] { return trace_alone("several_crew"); }), "trace 722fae80771eea36");
}

// Not under load: each switch between processes would wait for the busy one's turn.
TEST(Trace, OfRunsOfSeveralWithThreadsIsOne) {
  EXPECT_EQ(of_runs(std::max(kRuns / 2, 1), {Processors::Load::None},
                    [] { return trace_of_run("several_crew", "2"); }),
            "trace 6b06d43b0fe04119");
}

TEST(Trace, IsAnotherOneWhereAnythingElseWasSeen) {
  const std::string perfect = trace_of_run("senses", "2");
  EXPECT_EQ(trace_of_run("senses", "2", "perfect"), perfect);
  std::set<std::string> traces{perfect};
  std::vector<std::string> all{"psd sigma=100",   "psd sigma=101",  "robot:2 psd sigma=100",
                               "encoder miss=5%", "camera sigma=4", "radio loss=50%"};
#if defined(__SANITIZE_ADDRESS__)  // ten seconds a run
  all.resize(2);
#endif
  for (const std::string& errors : all) {
    EXPECT_TRUE(traces.insert(trace_of_run("senses", "2", errors)).second) << errors;
  }
}

}  // namespace
}  // namespace eyebridge
