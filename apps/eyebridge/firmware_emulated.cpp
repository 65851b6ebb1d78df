#include <array>
#include <cstdio>

#include <fmt/format.h>
#include <poll.h>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/mps2/emulated_board.hpp"
#include "firmware_parts.hpp"
#include "own_files.hpp"
#include "path_file.hpp"
#include "stop_signals.hpp"

namespace eyebridge::apps {
namespace {

constexpr int kLook_ms = 20;  // a pseudo-terminal does not tell that it was opened

/// One board on the emulated microcontroller, its line, its robot.
class EmulatedRun {
 public:
  EmulatedRun(const FirmwareOptions& options, const files::Scenario& scenario,
              const WantedBoard& wanted)
      : trace_(options.trace), path_(options.path), world_(scenario), start_(monotonic_now()) {
    mps2::EmulatorSettings settings;
    settings.elf = options.elf.empty() ? own_files().firmware.string() : options.elf;
    board_ = std::make_unique<mps2::EmulatedBoard>(settings, world_, 0,
                                                   board_config(options, wanted), monotonic_now);
    stop_on_signals();  // not earlier: a start that hangs ends by Ctrl-C, and the emulator with it
    ports_.push_back(open_byte_port(trace_.traced(board_->line()), wanted));
    print_start(ports_, options.world);
  }

  int run() {
    while (!stop_asked()) {
      wait();
      // Requests in, then what the firmware has to say to them.
      ports_[0]->pump();
      const auto moved = board_->pump();
      path_.note(monotonic_now() - start_, world_.simulation(), 1);
      ports_[0]->pump();
      if (!moved) {
        tell(moved.error().what);
        return kFailed;
      }
    }
    print_end(monotonic_now() - start_, world_, 1);
    return kFine;
  }

 private:
  void wait() {
    const std::array<pollfd, 2> lines = board_->descriptors();
    const ports::Port& port = *ports_[0];
    std::array<pollfd, 3> all{lines[0], lines[1], pollfd{port.descriptor(), POLLIN, 0}};
    if (port.wants_room()) all[2].events = POLLIN | POLLOUT;
    ::poll(all.data(), all.size(), kLook_ms);
  }

  FirmwareTrace trace_;
  PathFile path_;
  pins::BoardWorld world_;
  Time start_;
  std::unique_ptr<mps2::EmulatedBoard> board_;
  std::vector<std::unique_ptr<ports::Port>> ports_;  // one; it goes before its board
};

}  // namespace

int run_emulated(const FirmwareOptions& options, const files::Scenario& scenario,
                 const std::vector<WantedBoard>& wanted) {
  if (wanted.size() != 1) {
    throw ConfigError({"--cortex-m3"}, fmt::format("found {} boards, expected one", wanted.size()));
  }
  if (wanted[0].kind == WantedBoard::Kind::Can || wanted[0].kind == WantedBoard::Kind::Rover) {
    throw ConfigError({"--cortex-m3"},
                      "found --can, expected --pty or --tcp: the emulated board has no CAN");
  }
  return EmulatedRun(options, scenario, wanted[0]).run();
}

}  // namespace eyebridge::apps
