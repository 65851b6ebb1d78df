// Rows of the contract without a board: the simulation, and what answers in its place.
#include "eyebridge/hal/device_notes.hpp"
#include "fault/fault_injector.hpp"
#include "host/host_backend.hpp"
#include "mix/mix_backend.hpp"
#include "remote_rig.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

/// A busy computer lets a thread wait for a tenth of a second: at this speed the robot does not
/// drive from its start to the wall meanwhile.
std::map<std::string, std::string> real_time() { return {{"factor", "10"}}; }
Rig real_time_rig(const Pose& start) { return sim_rig(start, real_time()); }

/// A decorator that has nothing to do must not show.
Rig faultless_rig(const Pose& start) {
  Rig rig = lockstep_rig(start);
  rig.backend = with_faults(std::move(rig.backend), FaultScript{}, 1);
  return rig;
}
/// Nor one whose time has not come.
Rig rig_before_its_faults(const Pose& start) {
  Rig rig = lockstep_rig(start);
  FaultScript later = parse_fault_script("all lose @1000000s; all delay 1s @1000000s", {});
  rig.backend = with_faults(std::move(rig.backend), std::move(later), 1);
  return rig;
}

/// Nor does the computer that the program runs on.
Rig hosted_rig(const Pose& start) {
  Rig rig = lockstep_rig(start);
  rig.backend = with_host(std::move(rig.backend), {});
  return rig;
}

/// Nor does who notes it all for a window.
Rig noted_rig(const Pose& start) {
  Rig rig = lockstep_rig(start);
  rig.backend = with_notes(std::move(rig.backend)).backend;
  return rig;
}

/// Devices of another simulated robot, which follows this one, must not show at the others.
Rig mixed_rig(const Pose& start) {
  Rig rig = lockstep_rig(start);
  Rig other = lockstep_rig(start);
  std::vector<MixPart> parts;
  parts.push_back({{"servo", "camera"}, "other", std::move(other.backend)});
  rig.backend = make_mix(std::move(rig.backend), std::move(parts));
  rig.other_end = std::shared_ptr<KeepingLog>(std::move(other.log));
  rig.truth = truth_of(*rig.backend);
  return rig;
}

/// Nor does a line to another process, here to another thread.
Rig remote_robot_rig(const Pose& start, const std::map<std::string, std::string>& flags) {
  RemoteRig both = remote_rig(start, flags);
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  rig.other_end = std::shared_ptr<ServedRobot>(std::move(both.server));
  rig.backend = std::move(both.robot);
  rig.truth = truth_of(*rig.backend);
  return rig;
}
Rig virtual_remote_rig(const Pose& start) { return remote_robot_rig(start, {{"fast", "true"}}); }
Rig real_remote_rig(const Pose& start) { return remote_robot_rig(start, real_time()); }

}  // namespace

std::vector<RigCase> contract_rows() {
  RigTraits mixed = kSimulated;
  mixed.one_world = false;
  return {{"SimLockstep", lockstep_rig, kSimulated},
          {"SimRealTime", real_time_rig, kSimulated},
          {"FaultNone", faultless_rig, kSimulated},
          {"FaultLater", rig_before_its_faults, kSimulated},
          {"OnHost", hosted_rig, kSimulated},
          {"MixOther", mixed_rig, mixed},
          {"Noted", noted_rig, kSimulated},
          {"WorldSlot", virtual_remote_rig, kSimulated},
          {"RemoteRealTime", real_remote_rig, kSimulated},
          {"Replay", lockstep_rig, kReplayed, true}};
}

}  // namespace eyebridge::hal
