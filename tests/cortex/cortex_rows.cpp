// The contract's row whose board is machine code on the emulated Cortex-M3, over a pseudo-terminal.
#include <csignal>

#include "../hal/rig_traits.hpp"
#include "cortex_rig.hpp"

namespace eyebridge::hal {
namespace {

/// The emulator is one more process that has to get its turn.
constexpr RigTraits kEmulated = [] {
  RigTraits traits = in_real_time(kIo7BoardVw);
  traits.age += 0.05;
  return traits;
}();

Rig cortex_rig(const Pose& start) {
  const auto board = std::make_shared<mps2::CortexRig>(mps2::dialect(true), rig_scenario(start));
  Rig rig = board->open("io7vw");
  rig.other_end = board;
  rig.truth = [board] { return board->truth(); };
  rig.unplug = [board] {
    ::kill(board->pid(), SIGKILL);
    board->wait_for_end();
  };
  return rig;
}

}  // namespace

std::vector<RigCase> contract_rows() { return {{"Io7OnCortexM3", cortex_rig, kEmulated}}; }

}  // namespace eyebridge::hal
