// PSDGet() through the C API over a pseudo-terminal to the real firmware, against write() and
// read() of the same bytes on the same terminal just before. Target: 1.5 times the raw echo, median
// and 99 %.
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "eb_board.h"
#include "eyebridge/ports/lines.hpp"
#include "latencies.hpp"
#include <eyebot.h>

namespace eyebridge::bench {
namespace {

constexpr int kRange_raw = 1234;

/// The firmware on a terminal, on a thread that does nothing else.
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
    std::filesystem::remove_all(folder_);
  }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  static std::string new_folder() {
    std::string name = std::filesystem::temp_directory_path() / "eyebridge-bench-XXXXXX";
    need(::mkdtemp(name.data()) != nullptr, "mkdtemp");
    return name;
  }

  std::string folder_ = new_folder();
  std::string path_ = folder_ + "/eyebot.tty";
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
  need(reply[0] * 256 + reply[1] == kRange_raw, "the board answered something else");
}

void psd_get_over_a_pty(benchmark::State& state) {
  constexpr int kExchanges = 20'000;
  static Board board;  // the library keeps its connection for as long as the process lives
  static Latencies raw;
  static bool started = false;
  if (!started) {
    started = true;
    const int fd = ::open(board.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    need(fd >= 0, "open");
    for (int i = 0; i < 200; ++i) raw_exchange(fd);
    for (int i = 0; i < kExchanges; ++i) raw.time([&] { raw_exchange(fd); });
    ::close(fd);
    setenv("EYEBRIDGE_HAL", ("serial:" + board.path()).c_str(), 1);
    setenv("EYEBRIDGE_KEYS", "KEY1@1e9s", 1);  // a script, so that no terminal is asked
    need(PSDGetRaw(PSD_FRONT) == kRange_raw, "the board's reading");
  }
  Latencies ours;
  for (auto _ : state) {
    ours.time([] { need(PSDGetRaw(PSD_FRONT) == kRange_raw, "the board's reading"); });
  }
  report(state, ours, raw);
}
BENCHMARK(psd_get_over_a_pty)->UseRealTime();

}  // namespace
}  // namespace eyebridge::bench
