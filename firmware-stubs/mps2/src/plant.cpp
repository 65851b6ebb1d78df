#include "eyebridge/mps2/plant.hpp"

#include <fmt/format.h>

#include "eyebridge/pins/robot_pins.hpp"

namespace eyebridge::mps2 {
namespace {

constexpr double kMicrosecond = 1e-6;
// A sum of periods that is a hair less than a step is a step.
constexpr double kRounding = 1e-9;

void append(std::vector<std::uint8_t>& bytes, const std::vector<std::uint8_t>& more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

}  // namespace

Plant::Plant(pins::BoardWorld& world, robot::RobotIndex robot, const eb_config& config)
    : world_(world), robot_(robot), config_(config) {
  config_.drive =
      pins::drive_config(world.simulation().model(robot).drive, config.drive.stall_timeout_us);
}

std::vector<std::uint8_t> Plant::receive(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> reply;
  for (const std::uint8_t byte : bytes) {
    parser_.push(byte);
    while (const auto frame = parser_.next()) {
      if (const auto format = decode_hello(*frame)) {
        begin(*format, reply);
      } else if (const auto outputs = decode_outputs(*frame)) {
        exchange(frame->sequence, *outputs, reply);
      }
    }
  }
  return reply;
}

void Plant::begin(std::uint8_t format, std::vector<std::uint8_t>& reply) {
  if (format != kPlantFormat) {
    refusal_ = fmt::format("its firmware speaks format {} on the plant link, expected {}", format,
                           kPlantFormat);
    return;
  }
  if (!begun_ || moved_) ++starts_;  // else it only asks again
  begun_ = true;
  moved_ = false;
  sequence_ = 0;
  losses_known_ = losses_;
  pins_ = {};
  pins::obey_pins(pins_, world_.simulation(), robot_);
  pins::read_pins(world_.simulation(), robot_, pins_);
  answered_ = encode(encode_inputs(sequence_, pins_, losses_));
  append(reply, encode(encode_config(config_)));
  append(reply, answered_);
}

void Plant::exchange(std::uint8_t sequence, const PlantOutputs& outputs,
                     std::vector<std::uint8_t>& reply) {
  if (!begun_) return;
  if (sequence == sequence_ && moved_) {  // it has not had the answer yet
    append(reply, answered_);
    return;
  }
  if (sequence != static_cast<std::uint8_t>(sequence_ + 1)) return;
  sequence_ = sequence;
  moved_ = true;
  losses_known_ = outputs.losses;
  pins_ = outputs.pins;
  pins::obey_pins(pins_, world_.simulation(), robot_);
  elapsed_ += outputs.elapsed_us * kMicrosecond;
  const double step = world_.simulation().settings().step;
  for (; elapsed_ > step - kRounding; elapsed_ -= step) world_.step();
  pins::read_pins(world_.simulation(), robot_, pins_);
  ++periods_;
  answered_ = encode(encode_inputs(sequence_, pins_, losses_));
  append(reply, answered_);
}

}  // namespace eyebridge::mps2
