// PSDGet() through the C API over a pseudo-terminal to the real firmware, against write() and
// read() of the same bytes on the same terminal just before. Target: 1.5 times the raw echo, median
// and 99 %.
//
// EYEBRIDGE_BENCH_BOARD names the terminal of another board, which takes lines and answers with raw
// bytes: eyebridge firmware --world worlds/maze-5.maz --cortex-m3 --pty ./eyebot.tty
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "eb_board.h"
#include "eyebridge/ports/lines.hpp"
#include "latencies.hpp"
#include "run_program.hpp"
#include <eyebot.h>

namespace eyebridge::bench {
namespace {

constexpr int kRange_raw = 1234;

/// The terminal of a board that is not ours; null when there is none.
const char* other_board() { return std::getenv("EYEBRIDGE_BENCH_BOARD"); }

/// Ours tells what it was given; another one may see anything.
bool is_right(int reading) {
  return reading == kRange_raw || (reading >= 0 && other_board() != nullptr);
}

/// Our firmware on a terminal, on a thread that does nothing else.
class Board {
 public:
  Board() {
    eb_config config;
    eb_config_default(&config);
    eb_board_init(&board_, &config, nullptr);
    board_.pins.supply_cv = 740;
    for (std::uint16_t& psd : board_.pins.psd) psd = kRange_raw;
    port_ = ports::open_pty(ports::byte_line(board_), path_, {"bench"});
    thread_ = std::jthread([this](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        pollfd ready{port_->descriptor(), POLLIN, 0};
        ::poll(&ready, 1, 1);
        port_->pump();
      }
    });
  }
  ~Board() {
    thread_ = {};
    port_.reset();
  }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  testing::ScratchFolder folder_;
  std::string path_ = folder_.path() + "/eyebot.tty";
  eb_board board_{};
  std::unique_ptr<ports::Port> port_;
  std::jthread thread_;
};

/// "p 1" and two bytes, as the library sends and reads them.
void raw_exchange(int fd) {
  constexpr char kRequest[] = {'p', ' ', '1', '\r'};
  need(::write(fd, kRequest, sizeof kRequest) == sizeof kRequest, "write");
  unsigned char reply[2];
  for (std::size_t got = 0; got < sizeof reply;) {
    const ssize_t count = ::read(fd, reply + got, sizeof reply - got);
    need(count > 0, "read");
    got += static_cast<std::size_t>(count);
  }
  need(is_right(reply[0] * 256 + reply[1]), "the board answered something else");
}

void psd_get_over_a_pty(benchmark::State& state) {
  constexpr int kExchanges = 20'000;
  // The library keeps its connection for as long as the process lives.
  static std::unique_ptr<Board> board;
  static Latencies raw;
  static bool started = false;
  if (!started) {
    started = true;
    if (other_board() == nullptr) board = std::make_unique<Board>();
    const std::string path = board ? board->path() : other_board();
    const int fd = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    need(fd >= 0, "cannot open " + path);
    for (int i = 0; i < 200; ++i) raw_exchange(fd);
    for (int i = 0; i < kExchanges; ++i) raw.time([&] { raw_exchange(fd); });
    ::close(fd);
    setenv("EYEBRIDGE_HAL", ("serial:" + path).c_str(), 1);
    setenv("EYEBRIDGE_KEYS", "KEY1@1e9s", 1);  // a script, so that no terminal is asked
    need(is_right(PSDGetRaw(PSD_FRONT)), "the board's reading");
  }
  Latencies ours;
  for (auto _ : state) {
    ours.time([] { need(is_right(PSDGetRaw(PSD_FRONT)), "the board's reading"); });
  }
  report(state, ours, raw);
}
BENCHMARK(psd_get_over_a_pty)->UseRealTime();

}  // namespace
}  // namespace eyebridge::bench
