#include "board/board_backend.hpp"

#include <algorithm>
#include <utility>

#include <pthread.h>

#include "board/make_controller.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;

constexpr Time kPeriod = 10ms;
constexpr Time kTracePeriod = 100ms;

template <class Type>
Device* one_of(std::map<int, Type>& devices, int id) {
  const auto found = devices.find(id);
  return found == devices.end() ? nullptr : &found->second;
}

bool is_reversed(int id, const BoardDriveShape& shape) {
  return (id == 1 && shape.left_reversed) || (id == 2 && shape.right_reversed);
}

/// 0 of an encoder that sits on no wheel of the drive.
double ticks_per_metre(int id, const BoardDriveShape& shape) {
  if (id == 1) return shape.left_ticks_per_metre;
  return id == 2 ? shape.right_ticks_per_metre : 0.0;
}

}  // namespace

BoardBackend::BoardBackend(std::unique_ptr<Clock> line_clock, std::unique_ptr<BoardLink> link,
                           const BoardTables& tables)
    : line_clock_(std::move(line_clock)),
      link_(std::move(link)),
      clock_(*line_clock_),
      controller_(make_controller(*link_, *line_clock_, tables.drive)),
      lidar_(*link_),
      digital_(*link_),
      analog_(*link_),
      identity_(*link_),
      remote_(*link_),
      generation_(link_->generation()) {
  if (controller_) drive_.emplace(*controller_);
  for (const BoardPsdTable& psd : tables.psds) {
    if (link_->has_psd(psd.id)) range_sensors_.try_emplace(psd.id, *link_, psd);
  }
  for (int id = 1; id <= RangeMatrix::kLastId; ++id) range_matrices_.try_emplace(id, *link_, id);
  for (const BoardMotorTable& motor : tables.motors) {
    if (!link_->has_motor(motor.id)) continue;
    motors_.try_emplace(motor.id, *link_, motor, is_reversed(motor.id, tables.drive),
                        controller_.get());
  }
  for (const int id : tables.encoders) {
    if (link_->has_encoder(id)) {
      encoders_.try_emplace(id, *link_, id, is_reversed(id, tables.drive));
      encoder_facts_.push_back({id, "", 0, ticks_per_metre(id, tables.drive)});
    }
  }
  for (const BoardServoTable& servo : tables.servos) {
    if (link_->has_servo(servo.id)) servos_.try_emplace(servo.id, *link_, servo);
  }
}

BoardBackend::~BoardBackend() {
  ending_ = true;
  if (thread_.joinable()) thread_.join();
  (void)stop();
}

void BoardBackend::start() {
  if (line_clock_->is_virtual()) return;
  thread_ = std::thread([this] { run(); });
  // By this name robios knows that it is none of the program's own threads.
  pthread_setname_np(thread_.native_handle(), "eb:board");
}

void BoardBackend::run() {
  Time due = line_clock_->now();
  while (!ending_) {
    step();
    // A step that took long is not made up for.
    due = std::max(due + kPeriod, line_clock_->now());
    line_clock_->wait_until(due);
  }
}

void BoardBackend::step() {
  link_->look_after();
  if (link_->generation() != generation_) {
    generation_ = link_->generation();
    if (controller_) controller_->restarted();
    digital_.restarted();
  }
  if (controller_) controller_->step();
  trace();
}

void BoardBackend::trace() {
  const std::lock_guard lock(tracing_);
  const Time now = clock_.now();
  if (sink_ == nullptr || now < next_point_ || !drive_) return;
  next_point_ = now + kTracePeriod;
  const auto pose = drive_->odometry();
  const auto twist = drive_->measured_twist();
  if (!pose || !twist) return;
  ranges_.clear();
  for (auto& [id, sensor] : range_sensors_) {
    const auto range = sensor.read();
    if (!range) return;
    ranges_.push_back(*range);
  }
  sink_->point({now, *pose, *twist, *pose, ranges_});
}

std::vector<DeviceFacts> BoardBackend::facts_of(std::string_view kind) {
  return kind == "encoder" ? encoder_facts_ : std::vector<DeviceFacts>{};
}

void BoardBackend::trace_to(TraceSink* sink) {
  const std::lock_guard lock(tracing_);
  sink_ = sink;
}

Device* BoardBackend::find(DeviceKind kind, int id) {
  switch (kind) {
    case DeviceKind::Drive:
      return drive_ ? &*drive_ : nullptr;
    case DeviceKind::Motor:
      return one_of(motors_, id);
    case DeviceKind::Encoder:
      return one_of(encoders_, id);
    case DeviceKind::Servo:
      return one_of(servos_, id);
    case DeviceKind::Psd:
      return one_of(range_sensors_, id);
    case DeviceKind::Lidar:
      return link_->has_lidar() ? &lidar_ : nullptr;
    case DeviceKind::Tof:
      return link_->has_range_matrix(id) ? one_of(range_matrices_, id) : nullptr;
    case DeviceKind::Digital:
      return link_->has_digital() ? &digital_ : nullptr;
    case DeviceKind::Analog:
      return link_->has_analog() ? &analog_ : nullptr;
    case DeviceKind::Board:
      return &identity_;
    case DeviceKind::Remote:
      return link_->has_remote() ? &remote_ : nullptr;
    case DeviceKind::Proximity:
    case DeviceKind::Bumper:
    case DeviceKind::Compass:
    case DeviceKind::Gyroscope:
    case DeviceKind::Accelerometer:
    case DeviceKind::Serial:
    case DeviceKind::Sound:
    case DeviceKind::Radio:
      break;
  }
  return nullptr;
}

Result<void> BoardBackend::stop() noexcept {
  try {
    // Before the motors: a controller that is at work would start them again.
    if (controller_) controller_->release();
    return link_->stop();
  } catch (const std::exception&) {
    return tl::unexpected(Error{Errc::Disconnected, {}});  // no memory for a text
  }
}

}  // namespace eyebridge::hal
