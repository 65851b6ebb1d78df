#include "eyebridge/bridges/tcp.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;

/// A socket bound to a free port of the loopback. Only one that listens takes calls.
struct Bound {
  explicit Bound(int backlog) : fd(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(::bind(fd.get(), generic, size), 0);
    if (backlog >= 0) {
      EXPECT_EQ(::listen(fd.get(), backlog), 0);
    }
    EXPECT_EQ(::getsockname(fd.get(), generic, &size), 0);
    port = ntohs(address.sin_port);
  }

  UniqueFd fd;
  std::uint16_t port = 0;
};

TEST(Tcp, SaysThatNobodyListens) {
  MonotonicClock clock;
  const Bound mute(-1);
  const auto opened = open_tcp({"127.0.0.1", mute.port}, clock);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, Errc::Disconnected);
  EXPECT_EQ(opened.error().what,
            "127.0.0.1:" + std::to_string(mute.port) +
                ": connection refused; expected a board or firmware that listens there");
}

TEST(Tcp, GivesUpOnAHostThatDoesNotAnswer) {
  MonotonicClock clock;
  const Bound full(0);
  // Linux lets backlog + 1 connections wait; the next call gets no answer.
  const auto waiting = open_tcp({"127.0.0.1", full.port}, clock);
  ASSERT_TRUE(waiting) << what(waiting);
  const auto opened = open_tcp({"127.0.0.1", full.port, std::chrono::milliseconds(50)}, clock);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, Errc::Timeout);
  EXPECT_THAT(opened.error().what, HasSubstr("no answer within 50 ms"));
}

TEST(Tcp, SaysThatAHostIsUnknown) {
  MonotonicClock clock;
  // No name may be longer than 253 characters: refused without asking a name server.
  const auto opened = open_tcp({std::string(300, 'a'), 4711}, clock);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, Errc::Disconnected);
  EXPECT_THAT(opened.error().what, HasSubstr("unknown host"));
}

TEST(Tcp, NamesIpv6HostsInBrackets) {
  MonotonicClock clock;
  const auto opened = open_tcp({"::1", 1, std::chrono::milliseconds(50)}, clock);
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().what, ::testing::StartsWith("[::1]:1: "));
}

}  // namespace
}  // namespace eyebridge::bridges::testing
