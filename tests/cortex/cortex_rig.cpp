#include "cortex_rig.hpp"

#include <chrono>

#include <poll.h>

#include "eyebridge/hal/registry.hpp"
#include "eyebridge/pins/psd_table.hpp"
#include "eyebridge/pins/robot_pins.hpp"
#include "eyebridge/ports/lines.hpp"

namespace eyebridge::mps2 {
namespace {

using namespace std::chrono_literals;

constexpr auto kRigPatience = 60s;
constexpr int kLook_ms = 5;

Time now() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

eb_config dialect(bool vw) {
  eb_config config;
  eb_config_default(&config);
  config.io7.letters = vw ? EB_LETTERS_ALL : EB_LETTERS_PAGE;
  config.silence_us = 10'000'000;
  return config;
}

CortexRig::CortexRig(const eb_config& config, const files::Scenario& scenario)
    : hdt_(folder_.write("robot.hdt", pins::hdt_text(scenario.models[0]))),
      world_(scenario),
      board_(std::make_unique<EmulatedBoard>(EmulatorSettings{.elf = EYEBRIDGE_CORTEX_ELF}, world_,
                                             0, config, now)),
      port_(ports::open_pty(board_->line(), device(), {"rig"})),
      thread_([this](const std::stop_token& stop) { live(stop); }) {}

CortexRig::~CortexRig() = default;

void CortexRig::live(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    {
      const std::lock_guard lock(mutex_);
      port_->pump();
      const auto moved = board_->pump();
      port_->pump();
      if (!moved) {
        end_ = moved.error().what;
        port_.reset();
      }
    }
    turned_.notify_all();
    if (port_ == nullptr) return;
    const auto lines = board_->descriptors();
    std::array<pollfd, 3> all{lines[0], lines[1], pollfd{port_->descriptor(), POLLIN, 0}};
    if (port_->wants_room()) all[2].events = POLLIN | POLLOUT;
    ::poll(all.data(), all.size(), kLook_ms);
  }
}

std::string CortexRig::url(const std::string& profile) const {
  return "serial:" + device() + "?profile=" + profile + "&hdt=" + hdt_;
}

hal::Rig CortexRig::open(const std::string& profile) const {
  hal::Rig rig;
  rig.log = std::make_unique<hal::KeepingLog>();
  const hal::Config config = hal::rig_config({{"hal", url(profile)}});
  rig.backend = hal::open_backend({config, *rig.log});
  return rig;
}

bool CortexRig::wait_for(const std::function<bool(robot::Simulation&)>& seen) {
  std::unique_lock lock(mutex_);
  return turned_.wait_for(lock, kRigPatience, [&] { return seen(world_.simulation()); });
}

void CortexRig::look(const std::function<void(robot::Simulation&)>& show) {
  const std::lock_guard lock(mutex_);
  show(world_.simulation());
}

Pose CortexRig::pose() {
  Pose pose;
  look([&pose](robot::Simulation& simulation) { pose = simulation.pose(0); });
  return pose;
}

hal::Truth CortexRig::truth() {
  hal::Truth truth;
  look([&](robot::Simulation& world) {
    const robot::CameraModel& camera = *world.model(0).camera;
    const auto angle = [&](unsigned servo, double throw_angle) {
      return (2 * world.servo(0, servo) - 1) * throw_angle;
    };
    truth = {world.pose(0), camera.pan + angle(0, camera.max_pan),
             camera.tilt + angle(1, camera.max_tilt)};
  });
  return truth;
}

eb_pins CortexRig::pins() {
  eb_pins pins{};
  look([&pins](robot::Simulation& simulation) { pins::read_pins(simulation, 0, pins); });
  return pins;
}

std::string CortexRig::wait_for_end() {
  std::unique_lock lock(mutex_);
  turned_.wait_for(lock, kRigPatience, [&] { return !end_.empty(); });
  return end_;
}

}  // namespace eyebridge::mps2
