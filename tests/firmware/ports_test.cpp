#include <array>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <string>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <linux/can.h>
#include <netinet/in.h>
#include <poll.h>
#include <pty.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#include "board_fixture.hpp"
#include "eyebridge/ports/can_hub.hpp"
#include "eyebridge/ports/lines.hpp"
#include "eyebridge/ports/trace.hpp"
#include "run_program.hpp"

namespace eyebridge::firmware {
namespace {

using ports::Port;
using ::testing::HasSubstr;

constexpr int kPatience_ms = 20'000;

void send(int fd, const std::string& text) {
  ASSERT_EQ(::write(fd, text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

/// Pumps until `done`, waiting for either side; false when nothing happens for very long.
bool pump_until(Port& port, int host, const std::function<bool()>& done) {
  while (!done()) {
    port.pump();
    if (done()) break;
    pollfd both[] = {{host, POLLIN, 0}, {port.descriptor(), POLLIN, 0}};
    if (::poll(both, 2, kPatience_ms) == 0) return false;
  }
  return true;
}

/// What the host gets, until there are `size` bytes.
std::string answer_of(Port& port, int host, std::size_t size) {
  std::string answer;
  pump_until(port, host, [&] {
    pollfd ready{host, POLLIN, 0};
    std::array<char, 256> buffer{};
    while (::poll(&ready, 1, 0) > 0 && (ready.revents & POLLIN) != 0) {
      const ssize_t got = ::read(host, buffer.data(), buffer.size());
      if (got <= 0) return true;
      answer.append(buffer.data(), static_cast<std::size_t>(got));
    }
    return answer.size() >= size;
  });
  return answer;
}

class Pty : public ::testing::Test {
 protected:
  [[nodiscard]] UniqueFd open_host() const {
    return UniqueFd(::open(link.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  }

  eyebridge::testing::ScratchFolder folder;
  std::string link = folder.path() + "/eyebot.tty";
  BoardUnderTest board;
};

TEST_F(Pty, CarriesRequestsAndRepliesWithoutEcho) {
  const auto port = ports::open_pty(ports::byte_line(board.board), link, {"--pty"});
  EXPECT_EQ(port->address(), "serial:" + link);
  EXPECT_FALSE(port->connected());
  const UniqueFd host = open_host();
  ASSERT_TRUE(host.valid());
  termios settings{};
  ASSERT_EQ(tcgetattr(host.get(), &settings), 0);
  EXPECT_EQ(settings.c_lflag & (ECHO | ICANON | ISIG), 0U) << "raw before anybody sets it";
  send(host.get(), "v\rV\r");
  EXPECT_EQ(answer_of(*port, host.get(), 6), "1.04\x02\xE4");
  EXPECT_TRUE(port->connected());
}

TEST_F(Pty, AHostThatClosesStopsTheMotorsAndTheNextOneFindsTheName) {
  const auto port = ports::open_pty(ports::byte_line(board.board), link, {"--pty"});
  for (int visit = 0; visit < 3; ++visit) {
    UniqueFd host = open_host();
    send(host.get(), "m 1 50\rv\r");
    EXPECT_EQ(answer_of(*port, host.get(), 4), "1.04");
    EXPECT_EQ(board.board.pins.duty[0], 5000);
    send(host.get(), "m 1");  // half a request is nothing to the next host
    host.reset();
    ASSERT_TRUE(pump_until(*port, -1, [&] { return !port->connected(); }));
    EXPECT_EQ(board.board.pins.duty[0], 0);
    EXPECT_EQ(port->descriptor(), -1) << "nothing to wait for";
  }
}

TEST_F(Pty, ItsNameGoesAwayWithIt) {
  { const auto port = ports::open_pty(ports::byte_line(board.board), link, {"--pty"}); }
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(link)));
}

TEST_F(Pty, ALinkOfAKilledBoardIsReplacedWhileItsHostHoldsOn) {
  int master = -1;
  int slave = -1;
  char device[128] = {};
  ASSERT_EQ(::openpty(&master, &slave, device, nullptr, nullptr), 0);
  const UniqueFd host(slave);
  std::filesystem::create_symlink(device, link);
  EXPECT_THROW(ports::open_pty(ports::byte_line(board.board), link, {"--pty"}), ConfigError);
  ::close(master);
  const auto port = ports::open_pty(ports::byte_line(board.board), link, {"--pty"});
  EXPECT_NE(std::filesystem::read_symlink(link), device);
}

TEST_F(Pty, AFileThatIsThereIsLeftAlone) {
  folder.write("eyebot.tty", "mine");
  try {
    ports::open_pty(ports::byte_line(board.board), link, {"--pty"});
    FAIL() << "the name is taken";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--pty: found a file " + link));
  }
  EXPECT_EQ(eyebridge::testing::file_text(link), "mine");
}

TEST_F(Pty, ANameThatPointsNowhereIsTakenOver) {
  std::filesystem::create_symlink("/dev/pts/no-such", link);
  const auto port = ports::open_pty(ports::byte_line(board.board), link, {"--pty"});
  EXPECT_TRUE(open_host().valid());
}

UniqueFd connect_to(const std::string& address) {
  UniqueFd host(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  place.sin_port =
      htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
  if (::connect(host.get(), reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0) {
    host.reset();
  }
  return host;
}

TEST(Tcp, ServesOneHostAtATime) {
  BoardUnderTest board;
  const auto port = ports::open_tcp(ports::byte_line(board.board), "0", {"--tcp"});
  ASSERT_THAT(port->address(), ::testing::MatchesRegex("tcp:127.0.0.1:[0-9]+"));
  UniqueFd first = connect_to(port->address());
  ASSERT_TRUE(first.valid());
  send(first.get(), "m 1 50\rv\r");
  EXPECT_EQ(answer_of(*port, first.get(), 4), "1.04");
  const UniqueFd second = connect_to(port->address());
  port->pump();
  EXPECT_EQ(answer_of(*port, second.get(), 100), "busy: another host has this board\r\n");
  EXPECT_EQ(board.board.pins.duty[0], 5000);
  first.reset();
  ASSERT_TRUE(pump_until(*port, -1, [&] { return !port->connected(); }));
  EXPECT_EQ(board.board.pins.duty[0], 0);
  const UniqueFd third = connect_to(port->address());
  send(third.get(), "v\r");
  EXPECT_EQ(answer_of(*port, third.get(), 4), "1.04");
}

TEST(Tcp, BadAddressesAreNamed) {
  BoardUnderTest board;
  for (const char* address : {"", "x", "70000", "1.2.3:5", "localhost:1", "12:"}) {
    try {
      ports::open_tcp(ports::byte_line(board.board), address, {"--tcp"});
      FAIL() << address;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("expected a port 0 to 65535")) << address;
    }
  }
}

TEST(Tcp, APortThatIsTakenIsNamed) {
  BoardUnderTest board;
  const auto port = ports::open_tcp(ports::byte_line(board.board), "0", {"--tcp"});
  const std::string taken = port->address().substr(port->address().rfind(':') + 1);
  EXPECT_THROW(ports::open_tcp(ports::byte_line(board.board), taken, {"--tcp"}), ConfigError);
}

TEST(Can, CarriesFramesOverASocket) {
  int pair[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, pair), 0);
  UniqueFd host(pair[1]);
  BoardUnderTest board(config_with([](eb_config& config) { config.node = 1; }));
  const auto port = ports::make_can_port(ports::frame_line(board.board), UniqueFd(pair[0]));
  port->pump();
  can_frame got{};
  ASSERT_EQ(::read(host.get(), &got, sizeof got), static_cast<ssize_t>(sizeof got));
  EXPECT_EQ(got.can_id, 0x701U);
  EXPECT_EQ(got.can_dlc, 1);
  can_frame enable{};
  enable.can_dlc = 2;
  enable.data[0] = enable.data[1] = 1;
  can_frame drive{};
  drive.can_id = 0x231;
  drive.can_dlc = 8;
  drive.data[0] = 50;
  drive.data[4] = 1;
  can_frame other = drive;
  other.can_id |= CAN_EFF_FLAG;
  other.data[0] = 99;
  for (const can_frame& frame : {enable, drive, other}) {
    ASSERT_EQ(::write(host.get(), &frame, sizeof frame), static_cast<ssize_t>(sizeof frame));
  }
  port->pump();
  EXPECT_EQ(board.board.pins.duty[0], 5000) << "29-bit identifiers are not ours";
  host.reset();
  port->pump();
  EXPECT_FALSE(port->connected());
  EXPECT_EQ(board.board.pins.duty[0], 0);
}

/// A node on the bus of a hub.
UniqueFd node_on(const std::string& path) {
  UniqueFd node(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  EXPECT_EQ(::connect(node.get(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  return node;
}

// A program that ends sends a stop and is gone, whether or not it has read all that was for it.
TEST(Can, TheLastFrameOfANodeThatIsGoneIsPassedOn) {
  const eyebridge::testing::ScratchFolder folder;
  const std::string path = folder.path() + "/bus";
  const auto hub = ports::open_can_hub(path, {});
  ASSERT_TRUE(hub);
  const UniqueFd robot = node_on(path);
  UniqueFd program = node_on(path);
  hub->pump();
  can_frame unread{};
  unread.can_id = 0x181;
  ASSERT_EQ(::send(robot.get(), &unread, sizeof unread, 0), static_cast<ssize_t>(CAN_MTU));
  hub->pump();
  can_frame stop{};
  stop.can_id = 0x231;
  ASSERT_EQ(::send(program.get(), &stop, sizeof stop, 0), static_cast<ssize_t>(CAN_MTU));
  program.reset();
  hub->pump();
  can_frame got{};
  ASSERT_EQ(::recv(robot.get(), &got, sizeof got, MSG_DONTWAIT), static_cast<ssize_t>(CAN_MTU));
  EXPECT_EQ(got.can_id, 0x231U);
}

TEST(Can, WhatIsMissingIsToldApart) {
  const UniqueFd kernel(::socket(PF_CAN, SOCK_RAW, CAN_RAW));
  const int code = kernel.valid() ? ENODEV : errno;
  BoardUnderTest board;
  try {
    ports::open_can(ports::frame_line(board.board), "nocan7", false, 1, {"--can"});
    FAIL() << "there is no such interface";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("(errno " + std::to_string(code) + ")"));
  }
  EXPECT_THROW(ports::open_can(ports::frame_line(board.board), "", false, 1, {}), ConfigError);
  EXPECT_THROW(ports::open_can(ports::frame_line(board.board), "far-too-long-name", false, 1, {}),
               ConfigError);
}

TEST(Trace, WritesDownWhatPasses) {
  BoardUnderTest board(config_with([](eb_config& config) { config.node = 1; }));
  std::vector<std::string> lines;
  const auto sink = [&](std::string_view line) { lines.emplace_back(line); };
  const auto now = [] { return Time(std::chrono::microseconds(1'503'210)); };
  const auto bytes = ports::traced(ports::byte_line(board.board), sink, now);
  bytes.receive(std::array<std::uint8_t, 2>{'v', '\r'});
  std::array<std::uint8_t, 16> out{};
  EXPECT_EQ(bytes.transmit(out), 4U);
  EXPECT_EQ(bytes.transmit(out), 0U);
  const auto frames = ports::traced(ports::frame_line(board.board), "can0", sink, now);
  eb_can_frame frame{};
  EXPECT_TRUE(frames.transmit(frame));
  frames.receive(frame_of("000#0101"));
  EXPECT_THAT(lines,
              ::testing::ElementsAre("1503210 < 760D", "1503210 > 312E3034",
                                     "(1.503210) can0 701#00 T", "(1.503210) can0 000#0101 R"));
}

}  // namespace
}  // namespace eyebridge::firmware
