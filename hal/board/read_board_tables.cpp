// From an HDT file to what the devices need.
#include <algorithm>

#include <fmt/format.h>

#include "board/board_tables.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/hdt.hpp"
#include "eyebridge/files/readers.hpp"

namespace eyebridge::hal {
namespace {

/// Throws when the wheel `side`, 0 left or 1 right, is not where a board has it.
void check_wheel(const files::Hdt& hdt, std::size_t side) {
  const files::HdtDrive& drive = *hdt.drive;
  const int id = drive.encoders[side];
  const auto encoder = std::ranges::find(hdt.encoders, id, &files::HdtEncoder::id);
  if (encoder == hdt.encoders.end()) {
    throw ConfigError(drive.where,
                      fmt::format("DRIVE without ENCODER {}: expected its ticks per metre", id));
  }
  const int number = static_cast<int>(side) + 1;
  if (id != number || encoder->motor != number) {
    throw ConfigError(
        drive.where,
        fmt::format("found encoder {} on motor {} at the {} wheel, expected encoder and motor {}",
                    id, encoder->motor, side == 0 ? "left" : "right", number));
  }
}

void read_drive(const files::Hdt& hdt, BoardDriveShape& out) {
  const files::HdtDrive& drive = *hdt.drive;
  if (!robot::facts_of(drive.kind).has_two_wheels) {
    throw ConfigError(drive.where,
                      "found another drive than a differential one, expected two wheels");
  }
  for (const std::size_t side : {0U, 1U}) check_wheel(hdt, side);
  out.wheel_base = drive.wheel_base;
  out.left_reversed = drive.left_clockwise;
  out.right_reversed = drive.right_clockwise;
  if (drive.max_speed > 0) out.max_linear = drive.max_speed;
}

}  // namespace

BoardTables read_board_tables(const std::string& path, std::vector<Warning>& warnings) {
  const files::Hdt hdt = files::read_hdt(files::read_text_file(path), path, warnings);
  BoardTables tables;
  for (const files::HdtMotor& motor : hdt.motors) {
    BoardMotorTable& out = tables.motors.emplace_back();
    out.id = motor.id;
    if (const files::HdtTable* table = hdt.table_of(motor)) {
      for (const int percent : table->values) out.duty.push_back(percent / 100.0);
    }
  }
  for (const files::HdtServo& servo : hdt.servos) {
    BoardServoTable& out = tables.servos.emplace_back();
    out.id = servo.id;
    if (const files::HdtTable* table = hdt.table_of(servo)) out.position = table->values;
    const files::ServoLimits limits = files::servo_limits(servo);
    out.lower_10us = limits.lower;
    out.upper_10us = limits.upper;
  }
  for (const files::HdtPsd& psd : hdt.psds) {
    BoardPsdTable& out = tables.psds.emplace_back();
    out.id = psd.id;
    if (const files::HdtTable* table = hdt.table_of(psd)) {
      for (const int mm : table->values) {
        out.metres.push_back(std::min(mm_to_m(mm), kBoardOutOfRange));
      }
    }
  }
  for (const files::HdtEncoder& encoder : hdt.encoders) {
    tables.encoders.push_back(encoder.id);
    if (encoder.id == 1) tables.drive.left_ticks_per_metre = encoder.ticks_per_metre;
    if (encoder.id == 2) tables.drive.right_ticks_per_metre = encoder.ticks_per_metre;
  }
  if (hdt.drive) {
    read_drive(hdt, tables.drive);
  } else {
    warnings.push_back({{path}, "no DRIVE line: expected one; the wheels count as an S4's"});
  }
  return tables;
}

}  // namespace eyebridge::hal
