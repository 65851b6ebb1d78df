#include "eyebridge/base/deaf_thread.hpp"

#include <gtest/gtest.h>
#include <signal.h>

namespace eyebridge {
namespace {

bool is_blocked(int signal) {
  sigset_t mask;
  pthread_sigmask(SIG_SETMASK, nullptr, &mask);
  return sigismember(&mask, signal) == 1;
}

TEST(DeafThread, TakesNoSignalNorDoItsOwnThreadsAndItsMakerStillDoes) {
  bool itself = false;
  bool its_own = false;
  deaf_thread([&] {
    itself = is_blocked(SIGTERM) && is_blocked(SIGINT) && is_blocked(SIGUSR1);
    std::thread([&] { its_own = is_blocked(SIGTERM); }).join();
  }).join();
  EXPECT_TRUE(itself);
  EXPECT_TRUE(its_own);
  EXPECT_FALSE(is_blocked(SIGTERM));
}

}  // namespace
}  // namespace eyebridge
