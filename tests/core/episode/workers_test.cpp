// The threads that step many worlds.

#include "workers.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "eyebridge/episode/batch.hpp"
#include "rooms.hpp"

namespace eyebridge::episode {
namespace {

TEST(Workers, DoEveryIndexOnce) {
  Workers workers(4);
  for (const std::size_t count : {0U, 1U, 3U, 100U, 1000U}) {
    std::vector<int> done(count);
    workers.for_each(count, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(count, 1)) << count;
  }
}

TEST(Workers, ShareTheIndicesAmongAllThreads) {
  Workers workers(3);
  for (const std::size_t count : {3U, 100U}) {
    std::mutex mutex;
    std::condition_variable come;
    std::set<std::thread::id> seen;
    bool given_up = false;
    workers.for_each(count, [&](std::size_t) {
      std::unique_lock lock(mutex);
      seen.insert(std::this_thread::get_id());
      come.notify_all();
      // None goes on before all have come; the minute is for a failure to end.
      const auto go_on = [&] { return given_up || seen.size() == 3; };
      given_up = !come.wait_for(lock, std::chrono::minutes(1), go_on) || given_up;
    });
    ASSERT_EQ(seen.size(), 3U) << count;
  }
}

TEST(Workers, ThrowWhatTheLeastIndexThrewAndDoTheOthers) {
  Workers workers(3);
  std::vector<int> done(200);
  const auto fail_twice = [&](std::size_t i) {
    ++done[i];
    if (i == 60 || i == 150) throw std::runtime_error(std::to_string(i));
  };
  try {
    workers.for_each(done.size(), fail_twice);
    FAIL() << "threw nothing";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "60");
  }
  EXPECT_EQ(done, std::vector<int>(200, 1));
  workers.for_each(done.size(), [&](std::size_t i) { --done[i]; });
  EXPECT_EQ(done, std::vector<int>(200, 0)) << "the next loop is one like any other";
}

std::vector<std::uint64_t> hashes_with(unsigned threads) {
  const auto scenario = rough_room();
  EpisodeBatch batch({scenario}, {.worlds = 17, .threads = threads});
  batch.reset_all(3);
  std::vector<double> actions;
  std::vector<std::uint8_t> resets(17);
  for (int i = 0; i < 17; ++i) actions.insert(actions.end(), {0.1 + 0.02 * i, 0.2});
  for (int step = 0; step < 60; ++step) {
    resets.assign(17, 0);
    resets[static_cast<std::size_t>(step % 17)] = 1;
    batch.step(actions, resets);
  }
  std::vector<std::uint64_t> out;
  for (std::size_t i = 0; i < 17; ++i) out.push_back(batch.episode(i).simulation().state_hash());
  return out;
}

TEST(EpisodeBatch, GivesTheSameBitsOnAnyNumberOfThreads) {
  const auto one = hashes_with(1);
  EXPECT_EQ(hashes_with(2), one);
  EXPECT_EQ(hashes_with(7), one);
}

}  // namespace
}  // namespace eyebridge::episode
