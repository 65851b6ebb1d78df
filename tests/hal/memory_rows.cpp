// Rows of the contract whose boards are behind lines in memory: host and firmware in one thread and
// in virtual time, so that they are fast and every run is the same.
#include "../firmware/bridge_lines.hpp"
#include "board/board_backend.hpp"
#include "board/can_link.hpp"
#include "board/dbc_link.hpp"
#include "board/open_board.hpp"
#include "borrowed_clock.hpp"
#include "eyebridge/bridges/memory.hpp"
#include "rig_board.hpp"
#include "turns.hpp"

namespace eyebridge::hal {
namespace {

using testing::BorrowedClock;
using testing::by_turns;
using testing::RigBoard;
using testing::TurnClock;

/// Everything beyond the host's end of the line, and the time that both live in.
struct Bench {
  Bench(const Pose& start, const testing::RigFirmware& firmware) : board(start, firmware) {
    clock.board = [this](Time now) { board.live(now); };
  }
  /// What the host's thread does is done by the clock from now on.
  void adopt(BoardBackend& backend) {
    clock.host = [&backend] { backend.step(); };
  }

  TurnClock clock;
  std::unique_ptr<bridges::MemoryCan> bus;
  std::unique_ptr<bridges::ByteStream> wire;
  std::unique_ptr<bridges::CanBus> node;
  RigBoard board;
};

/// A rig around `bench`, whose backend `open` makes of a URL.
template <class Open>
Rig bench_rig(const std::shared_ptr<Bench>& bench, const std::string& url, Open&& open) {
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  rig.other_end = bench;
  const Config config = rig_config({{"hal", url}});
  rig.backend = open(parse_backend_url(url, {"rig"}), BackendContext{config, *rig.log});
  bench->adopt(dynamic_cast<BoardBackend&>(*rig.backend));
  rig.truth = [bench] { return bench->board.truth(); };
  rig.unplug = [bench] {
    bench->board.unplug();
    bench->wire.reset();
    bench->node.reset();
  };
  return rig;
}

Rig io7_rig(const Pose& start, bool on_board) {
  auto bench = std::make_shared<Bench>(start, testing::RigFirmware{.vw_letters = on_board});
  auto [near, far] = bridges::make_memory_streams(bench->clock);
  bench->wire = std::move(far);
  bench->board.connect(firmware::port_on(ports::byte_line(bench->board.board()), *bench->wire));
  using Line = std::unique_ptr<bridges::ByteStream>;
  auto line = std::make_shared<Line>(by_turns(std::move(near), bench->clock));
  const auto once = [line]() -> Result<Line> {
    if (*line == nullptr) return fail(Errc::Disconnected, "memory: there is one line only");
    return std::move(*line);
  };
  const std::string url =
      "serial:memory?hdt=" + bench->board.hdt() + (on_board ? "&profile=io7vw" : "");
  return bench_rig(bench, url, [&](const BackendUrl& parsed, const BackendContext& context) {
    return open_io7_board(parsed, context, once, std::make_unique<BorrowedClock>(bench->clock));
  });
}

Rig can_rig(const Pose& start, bool fd, bool with_hdt) {
  constexpr int kNode = 3;
  auto bench = std::make_shared<Bench>(start, testing::RigFirmware{.node = kNode, .can_fd = fd});
  bench->bus = std::make_unique<bridges::MemoryCan>(bench->clock, 512, fd);
  bench->node = bench->bus->connect("robot");
  bench->board.connect(firmware::port_on(ports::frame_line(bench->board.board()), *bench->node));
  const std::string url =
      "can:memory?node=3" + (with_hdt ? "&hdt=" + bench->board.hdt() : std::string());
  return bench_rig(bench, url, [&](const BackendUrl& parsed, const BackendContext& context) {
    auto backend =
        open_can_board(parsed, context, by_turns(bench->bus->connect("can0"), bench->clock),
                       std::make_unique<BorrowedClock>(bench->clock));
    auto& link = dynamic_cast<CanLink&>(dynamic_cast<BoardBackend&>(*backend).link());
    bench->clock.listen = [&link](Time until) { link.client().pump(until); };
    return backend;
  });
}

/// Another robot, by the files that describe it.
Rig rover_rig(const Pose& start) {
  auto bench = std::make_shared<Bench>(start, testing::RigFirmware{.rover = true});
  bench->bus = std::make_unique<bridges::MemoryCan>(bench->clock, 512, false);
  bench->node = bench->bus->connect("robot");
  bench->board.connect(firmware::port_on(ports::frame_line(bench->board.rover()), *bench->node));
  const std::string folder = EYEBRIDGE_SOURCE_DIR "/examples/rover/rover.";
  const std::string url = "can:memory?dbc=" + folder + "dbc&map=" + folder + "toml";
  return bench_rig(bench, url, [&](const BackendUrl& parsed, const BackendContext& context) {
    auto backend =
        open_can_board(parsed, context, by_turns(bench->bus->connect("can0"), bench->clock),
                       std::make_unique<BorrowedClock>(bench->clock));
    auto& link = dynamic_cast<DbcLink&>(dynamic_cast<BoardBackend&>(*backend).link());
    bench->clock.listen = [&link](Time until) { link.client().pump(until); };
    return backend;
  });
}

}  // namespace

std::vector<RigCase> contract_rows() {
  return {{"Io7HostVw", [](const Pose& start) { return io7_rig(start, false); }, kIo7HostVw},
          {"Io7BoardVw", [](const Pose& start) { return io7_rig(start, true); }, kIo7BoardVw},
          {"Can", [](const Pose& start) { return can_rig(start, false, true); }, kCan},
          {"CanWithoutHdt", [](const Pose& start) { return can_rig(start, false, false); },
           kCanWithoutHdt},
          {"CanFd", [](const Pose& start) { return can_rig(start, true, true); }, kCan},
          {"Rover", rover_rig, kRover}};
}

}  // namespace eyebridge::hal
