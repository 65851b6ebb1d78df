// The socket by which other processes find a run.
#include "control_socket.hpp"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "run_program.hpp"

namespace eyebridge::robios {
namespace {

class ControlSocket : public ::testing::Test {
 protected:
  ControlSocket() { setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1); }

 private:
  testing::ScratchFolder folder_;
};

TEST_F(ControlSocket, IsFoundWhileItsRunLives) {
  EXPECT_THAT(controllable_runs(), ::testing::IsEmpty());
  {
    const UniqueFd listener = open_control_socket();
    ASSERT_TRUE(listener.valid());
    EXPECT_THAT(controllable_runs(), ::testing::ElementsAre(getpid()));
    const UniqueFd visitor = connect_to_run(getpid());
    ASSERT_TRUE(visitor.valid());
    const UniqueFd server = accept_next(listener);
    ASSERT_TRUE(send_words(visitor, {"add", "", "S4"}));
    EXPECT_EQ(receive_words(server), (Words{"add", "", "S4"}));
  }
  EXPECT_FALSE(connect_to_run(getpid()).valid());
  EXPECT_THAT(controllable_runs(), ::testing::IsEmpty()) << "what is left of it is taken away";
}

// Who asked between bind() and listen() took its name away, and nobody found the run any more.
TEST_F(ControlSocket, IsNotTakenAwayByWhoAsksTooEarly) {
  std::atomic<bool> is_over = false;
  std::thread asks([&] {
    while (!is_over) static_cast<void>(connect_to_run(getpid()));
  });
  int lost = 0;
  for (int i = 0; i < 2000; ++i) {
    const UniqueFd listener = open_control_socket();
    if (!std::filesystem::exists(control_socket_of(getpid()))) ++lost;
    close_control_socket();
  }
  is_over = true;
  asks.join();
  EXPECT_EQ(lost, 0) << "of 2000";
}

}  // namespace
}  // namespace eyebridge::robios
