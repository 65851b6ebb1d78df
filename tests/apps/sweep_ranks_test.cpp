// One sweep on several ranks: without MPI, and by mpirun.

#include <deque>
#include <map>
#include <mutex>
#include <span>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __SANITIZE_ADDRESS__
#include <pthread.h>
// Of libasan; g++ 12 has no header for it.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*malloc_hook)(const volatile void*,
                                                                             std::size_t),
                                                         void (*free_hook)(const volatile void*));
#endif

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "sweep/ranks.hpp"

namespace eyebridge::apps {
namespace {

using ::testing::HasSubstr;
using testing::ScratchFolder;

/// What ranks in this process have to tell each other.
struct Post {
  std::mutex mutex;
  std::map<int, std::deque<std::pair<int, std::string>>> boxes;
};

class MemoryLink final : public RankLink {
 public:
  MemoryLink(Post& post, int rank, int size) : post_(post), rank_(rank), size_(size) {}
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }
  void send(int to, const std::string& text) override {
    const std::lock_guard lock(post_.mutex);
    post_.boxes[to].emplace_back(rank_, text);
  }
  std::optional<std::pair<int, std::string>> receive() override {
    const std::lock_guard lock(post_.mutex);
    auto& box = post_.boxes[rank_];
    if (box.empty()) return std::nullopt;
    auto message = std::move(box.front());
    box.pop_front();
    return message;
  }

 private:
  Post& post_;
  const int rank_;
  const int size_;
};

class Ranks : public ::testing::Test {
 protected:
  Ranks() {
    const std::string program = folder_.write("prog", "#!/bin/sh\necho result n $1\nexit $1\n");
    chmod(program.c_str(), 0755);
    for (int i = 0; i < 7; ++i) cells_.push_back({program, {std::to_string(i)}, {}, {}, {}});
    settings_.command = EYEBRIDGE_BIN "/eyebridge";
    settings_.folder = folder_.path() + "/runs";
    settings_.wall_limit = 60;  // a run that hangs is told, before the whole test is ended
  }
  std::thread worker(int rank, std::vector<Cell> cells, const std::string& problem = "") {
    return std::thread([this, rank, cells = std::move(cells), problem] {
      MemoryLink link(post_, rank, 3);
      serve_rank(link, cells, settings_, problem);
    });
  }
  std::string greeting(const std::string& problem = "") {
    try {
      greet_ranks(master_, cells_, problem);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  ScratchFolder folder_;
  std::vector<Cell> cells_;
  RunSettings settings_;
  Post post_;
  MemoryLink master_{post_, 0, 3};
};

TEST_F(Ranks, ShareOutAllRuns) {
  std::thread one = worker(1, cells_);
  std::thread two = worker(2, cells_);
  ASSERT_EQ(greeting(), "");
  std::map<std::size_t, Outcome> outcomes;
  const std::vector<std::size_t> todo = {0, 1, 3, 4, 5, 6};
  EXPECT_TRUE(run_on_ranks(
      master_, todo, [&](std::size_t i, const Outcome& outcome) { outcomes[i] = outcome; },
      [] { return false; }));
  one.join();
  two.join();
  ASSERT_EQ(outcomes.size(), todo.size());
  for (const auto& [index, outcome] : outcomes) {
    EXPECT_EQ(outcome.exit_code, static_cast<int>(index));
    EXPECT_EQ(outcome.results.at(0).second, std::to_string(index));
    EXPECT_EQ(outcome.well(), index == 0);
  }
}

#ifdef __SANITIZE_ADDRESS__  // whose heap can be watched
bool is_copy = false;        // of this process, made by fork()
void tell() {
  if (is_copy) _exit(42);
}

TEST_F(Ranks, StartRunsWithoutTheHeap) {
  // Between fork() and execve() another thread's lock on the heap would stay taken for ever.
  pthread_atfork(nullptr, nullptr, [] { is_copy = true; });
  __sanitizer_install_malloc_and_free_hooks([](const volatile void*, std::size_t) { tell(); },
                                            [](const volatile void*) { tell(); });
  settings_.command = "/bin/true";
  cells_.resize(1);
  cells_[0].environment = {{"NAME", "value"}};
  const std::size_t todo = 0;
  Outcome outcome;
  run_cells(
      cells_, std::span(&todo, 1), settings_, [&](std::size_t, const Outcome& o) { outcome = o; },
      [] { return false; });
  EXPECT_TRUE(outcome.well()) << outcome.how << ": " << outcome.reason;
}
#endif

TEST_F(Ranks, GoHomeWhenItIsStopped) {
  cells_[0].program = folder_.write("long", "#!/bin/sh\nexec sleep 1000\n");
  chmod(cells_[0].program.c_str(), 0755);
  std::thread one = worker(1, cells_);
  std::thread two = worker(2, cells_);
  ASSERT_EQ(greeting(), "");
  const std::vector<std::size_t> todo = {0, 1};
  int ended = 0;
  EXPECT_FALSE(run_on_ranks(
      master_, todo, [&](std::size_t, const Outcome&) { ++ended; }, [&] { return ended == 1; }));
  one.join();
  two.join();
  EXPECT_EQ(ended, 1) << "what is cut short is no outcome";
}

TEST_F(Ranks, RunNothingWithAProblemAnywhere) {
  {
    std::thread one = worker(1, cells_);
    std::thread two = worker(2, {}, "gone.wld: no such file");
    EXPECT_EQ(greeting(), "rank 2 says: gone.wld: no such file");
    one.join();
    two.join();
  }
  {
    std::thread one = worker(1, cells_);
    std::thread two = worker(2, cells_);
    EXPECT_EQ(greeting("bad flag"), "bad flag");
    one.join();
    two.join();
  }
  std::vector<Cell> others = cells_;
  others[3].arguments = {"x"};
  std::thread one = worker(1, cells_);
  std::thread two = worker(2, others);
  EXPECT_THAT(greeting(), HasSubstr("rank 2 found other runs"));
  one.join();
  two.join();
}

TEST_F(Ranks, OutsideMpirunThereAreNone) {
  EXPECT_EQ(open_rank_link("/no/such/library.so"), nullptr);
}

TEST_F(Ranks, WithoutItsLibraryMpirunIsRefused) {
  const testing::ProgramRun r = testing::run_program(
      {{"sh", "-c",
        "cp -r " EYEBRIDGE_BIN "/eyebridge . && OMPI_COMM_WORLD_SIZE=2 ./eyebridge sweep "
        "./prog"},
       {},
       folder_.path()});
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("mpirun: found no MPI in this eyebridge"));
}

#ifdef EYEBRIDGE_TEST_MPIRUN

class Mpirun : public Ranks {
 protected:
  testing::ProgramRun mpirun(const std::vector<std::string>& words) {
    std::vector<std::string> command = {EYEBRIDGE_TEST_MPIRUN,
                                        "--allow-run-as-root",
                                        "--oversubscribe",
                                        "-np",
                                        "3",
                                        EYEBRIDGE_BIN "/eyebridge",
                                        "sweep"};
    command.insert(command.end(), words.begin(), words.end());
    // Open MPI leaves memory behind, and asks all networks for others: there are none here.
    return testing::run_program({command,
                                 {{"ASAN_OPTIONS", "detect_leaks=0"},
                                  {"XDG_CONFIG_HOME", "/dev/null/none"},
                                  {"TMPDIR", "/tmp"},
                                  {"OMPI_MCA_btl", "self,vader"}},
                                 folder_.path()});
  }
};

TEST_F(Mpirun, RunsASweepOnItsRanks) {
  const std::vector<std::string> sweep = {"--seed", "1..4",        "--by", "program", "--parameter",
                                          "n=0",    "--parameter", "n=3",  "./prog",  "{n}"};
  const testing::ProgramRun r = mpirun(sweep);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("program=prog: 8 runs, 4 ended, 4 failed\n"));
  EXPECT_THAT(r.err, HasSubstr("8/8 prog"));
  const testing::ProgramRun again = mpirun(sweep);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, ::testing::Not(HasSubstr("/8 prog"))) << "all were there";
}

TEST_F(Mpirun, SaysOnceWhatIsWrong) {
  const testing::ProgramRun r = mpirun({"--robot", "R2D2", "./prog"});
  EXPECT_EQ(r.exit_code, 2);
  const std::size_t first = r.err.find("R2D2");
  ASSERT_NE(first, std::string::npos) << r.err;
  EXPECT_EQ(r.err.find("R2D2", first + 1), std::string::npos) << r.err;
}

#endif

}  // namespace
}  // namespace eyebridge::apps
