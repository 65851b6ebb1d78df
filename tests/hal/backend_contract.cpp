#include "backend_contract.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <unistd.h>

#include "eyebridge/base/math.hpp"
#include "eyebridge/hal/registry.hpp"
#include "replay/recorder.hpp"

namespace eyebridge::hal {

BackendContract::~BackendContract() {
  for (rigs_ = 1; rigs_ <= recordings_; ++rigs_) {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(recording() + end);
  }
}

std::string BackendContract::recording() const {
  std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::ranges::replace(test, '/', '_');
  return testing::TempDir() + "/contract_" + test + "_" + std::to_string(::getpid()) + "_" +
         std::to_string(rigs_) + ".ebrec";
}

void BackendContract::SetUp() {
  if (!GetParam().replayed) return;
  rehearsing_ = true;
  TestBody();
  rehearsing_ = false;
  rigs_ = 0;
}

const RigTraits& BackendContract::traits() const {
  return rehearsing_ ? kSimulated : GetParam().traits;
}

Rig BackendContract::make_at(const Pose& start) {
  const RigCase& row = GetParam();
  if (!row.replayed) return row.make(start);
  ++rigs_;
  if (rehearsing_) {
    recordings_ = rigs_;
    Rig rig = row.make(start);
    rig.backend = with_recording(std::move(rig.backend), recording(), *rig.log);
    return rig;
  }
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  const Config config = rig_config({{"hal", "replay:" + recording()}});
  rig.backend = open_backend({config, *rig.log});
  return rig;
}

void BackendContract::expect_truly_at(const Rig& rig, const Pose& pose) const {
  if (!rig.truth) return;
  const Pose truth = rig.truth().pose;
  EXPECT_NEAR(truth.x, pose.x, traits().way);
  EXPECT_NEAR(truth.y, pose.y, traits().way);
  EXPECT_NEAR(wrap_angle(truth.theta - pose.theta), 0.0, traits().turn);
}

}  // namespace eyebridge::hal
