// Rows of the contract whose boards are behind lines of the operating system, opened as programs
// open them, with all threads, in the computer's time.
#include <cstdlib>

#include <sys/socket.h>

#include "board/open_board.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/bridges/socket_can.hpp"
#include "eyebridge/hal/registry.hpp"
#include "eyebridge/ports/lines.hpp"
#include "rig_board.hpp"

namespace eyebridge::hal {
namespace {

using testing::RigBoard;
using testing::RigFirmware;

const SourceLocation kHere{"rig"};

Rig around(const std::shared_ptr<RigBoard>& board) {
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  rig.other_end = board;
  rig.truth = [board] { return board->truth(); };
  rig.unplug = [board] { board->unplug(true); };
  board->start();
  return rig;
}

/// By the registry.
Rig opened(const std::shared_ptr<RigBoard>& board, const Config& config) {
  Rig rig = around(board);
  rig.backend = open_backend({config, *rig.log});
  return rig;
}

/// As `--hal URL --hdt FILE`.
Rig opened(const std::shared_ptr<RigBoard>& board, const std::string& options) {
  return opened(board,
                rig_config({{"hal", board->port().address() + options}, {"hdt", board->hdt()}}));
}

const std::string kRoverFiles = EYEBRIDGE_SOURCE_DIR "/examples/rover/rover.";
const std::string kRoverOptions = "?dbc=" + kRoverFiles + "dbc&map=" + kRoverFiles + "toml";

/// A terminal, whose bytes wait for a thread of the kernel: a busy computer has let them wait for
/// longer than the 300 ms after which a board stops. So this one drives itself, and is patient.
Rig pty_rig(const Pose& start) {
  auto board = std::make_shared<RigBoard>(start, RigFirmware{.silence_ms = 5000});
  board->connect(
      ports::open_pty(ports::byte_line(board->board()), board->folder() + "/eyebot.tty", kHere));
  return opened(board, "?profile=io7vw");
}

/// v-omega on the host: the line is in its control loop.
Rig tcp_rig(const Pose& start) {
  auto board = std::make_shared<RigBoard>(start, RigFirmware{.vw_letters = false});
  board->connect(ports::open_tcp(ports::byte_line(board->board()), "0", kHere));
  return opened(board, "");
}

Rig socketpair_rig(const Pose& start) {
  constexpr int kNode = 5;
  int ends[2] = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  UniqueFd host(ends[0]);
  UniqueFd robot(ends[1]);
  auto board = std::make_shared<RigBoard>(start, RigFirmware{.node = kNode});
  board->connect(ports::make_can_port(ports::frame_line(board->board()), std::move(robot)));
  Rig rig = around(board);
  const Config config = rig_config({{"hal", "can:pair?node=5"}, {"hdt", board->hdt()}});
  auto clock = std::make_unique<bridges::MonotonicClock>();
  auto bus = bridges::make_socket_can({std::move(host), false}, "pair", *clock);
  rig.backend = open_can_board(parse_backend_url("can:pair?node=5", kHere), {config, *rig.log},
                               std::move(bus), std::move(clock));
  return rig;
}

/// Another robot, by the files that describe it.
Rig rover_rig(const Pose& start) {
  int ends[2] = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  UniqueFd host(ends[0]);
  UniqueFd robot(ends[1]);
  auto board = std::make_shared<RigBoard>(start, RigFirmware{.rover = true});
  board->connect(ports::make_can_port(ports::frame_line(board->rover()), std::move(robot)));
  Rig rig = around(board);
  const std::string url = "can:pair" + kRoverOptions;
  const Config config = rig_config({{"hal", url}});
  auto clock = std::make_unique<bridges::MonotonicClock>();
  auto bus = bridges::make_socket_can({std::move(host), false}, "pair", *clock);
  rig.backend = open_can_board(parse_backend_url(url, kHere), {config, *rig.log}, std::move(bus),
                               std::move(clock));
  return rig;
}

/// An interface of the kernel, by its name. A test may have several robots: each has a number of
/// its own.
Rig interface_rig(const std::string& interface, const Pose& start) {
  static int last = 0;
  const int node = last = last % 14 + 1;
  auto board = std::make_shared<RigBoard>(start, RigFirmware{.node = node});
  board->connect(ports::open_can(ports::frame_line(board->board()), interface, false, node, kHere));
  return opened(board, "");
}

/// The other robot on an interface of the kernel. It has no number: one at a time.
Rig rover_interface_rig(const std::string& interface, const Pose& start) {
  auto board = std::make_shared<RigBoard>(start, RigFirmware{.rover = true});
  board->connect(ports::open_can(ports::frame_line(board->rover()), interface, false, 0, kHere));
  return opened(board, rig_config({{"hal", "can:" + interface + kRoverOptions}}));
}

}  // namespace

std::vector<RigCase> contract_rows() {
  std::vector<RigCase> rows{{"Io7BoardVwOverPty", pty_rig, in_real_time(kIo7BoardVw)},
                            {"Io7HostVwOverTcp", tcp_rig, in_real_time(kIo7HostVw)},
                            {"CanOverSocketPair", socketpair_rig, in_real_time(kCan)},
                            {"RoverOverSocketPair", rover_rig, in_real_time(kRover)}};
  // Set in the lab, "vcan0,vcan1".
  if (const char* const named = std::getenv("EYEBRIDGE_TEST_CAN")) {
    const std::string names(named);
    const std::string first = names.substr(0, names.find(','));
    const auto rig = [first](const Pose& start) { return interface_rig(first, start); };
    rows.push_back({"CanOver_" + first, rig, in_real_time(kCan)});
    const auto rover = [first](const Pose& start) { return rover_interface_rig(first, start); };
    rows.push_back({"RoverOver_" + first, rover, in_real_time(kRover)});
  }
  return rows;
}

}  // namespace eyebridge::hal
