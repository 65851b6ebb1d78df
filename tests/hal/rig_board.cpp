#include "rig_board.hpp"

#include <algorithm>

#include "eyebridge/pins/psd_table.hpp"

namespace eyebridge::hal::testing {
namespace {

eb_config config_of(const RigFirmware& firmware) {
  eb_config config;
  eb_config_default(&config);
  config.io7.letters = firmware.vw_letters ? EB_LETTERS_ALL : EB_LETTERS_PAGE;
  config.node = static_cast<std::uint8_t>(firmware.node);
  config.can_fd = firmware.can_fd;
  config.silence_us = static_cast<std::uint32_t>(firmware.silence_ms) * 1000U;
  return config;
}

}  // namespace

RigBoard::RigBoard(const Pose& start, const RigFirmware& firmware)
    : hdt_(folder_.write("hdt.txt", pins::hdt_text(rig_model()))), world_(rig_scenario(start)) {
  if (firmware.rover) {
    rover_ = &world_.add_rover(0);
  } else {
    board_ = &world_.add_board(0, config_of(firmware));
  }
}

RigBoard::~RigBoard() = default;

Time RigBoard::live(Time now) {
  const std::lock_guard lock(mutex_);
  if (port_) port_->pump();
  const Time due = world_.advance(now);
  if (port_) port_->pump();
  return due;
}

void RigBoard::unplug(bool noticed) {
  const std::lock_guard lock(mutex_);
  port_.reset();
  if (noticed && board_ != nullptr) eb_board_link_lost(board_);
  if (noticed && rover_ != nullptr) rv_rover_lost(rover_);
}

void RigBoard::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

pollfd RigBoard::what_to_wait_for() {
  const std::lock_guard lock(mutex_);
  if (!port_) return {-1, 0, 0};
  const short room = port_->wants_room() ? POLLIN | POLLOUT : POLLIN;
  return {port_->descriptor(), room, 0};
}

void RigBoard::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const Time due = live(time_.now());
    pollfd entry = what_to_wait_for();
    const Time left = std::clamp<Time>(due - time_.now(), Time{0}, std::chrono::milliseconds(10));
    const timespec timeout{0, static_cast<long>(left.count())};
    ::ppoll(&entry, 1, &timeout, nullptr);
  }
}

Truth RigBoard::truth() {
  const std::lock_guard lock(mutex_);
  const robot::Simulation& world = world_.simulation();
  const robot::CameraModel& camera = *world.model(0).camera;
  const auto angle = [&](unsigned servo, double throw_angle) {
    return (2 * world.servo(0, servo) - 1) * throw_angle;
  };
  return {world.pose(0), camera.pan + angle(0, camera.max_pan),
          camera.tilt + angle(1, camera.max_tilt)};
}

}  // namespace eyebridge::hal::testing
