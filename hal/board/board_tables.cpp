#include "board/board_tables.hpp"

#include "eyebridge/base/math.hpp"

namespace eyebridge::hal {
namespace {

constexpr int kMotors = 4;
constexpr int kServos = 14;
constexpr int kPsds = 6;

/// Sharp's GP2Y0A21 between 0.1 m and 0.8 m: 0.29988 m * (U / 1 V)^-1.173, a common fit to the
/// curve in its data sheet.
std::vector<double> sharp_curve() {
  constexpr int kEntries = 256;
  constexpr double kReference = 2.7;
  std::vector<double> metres(kEntries, kBoardOutOfRange);
  for (int i = 1; i < kEntries; ++i) {
    const double range = 0.29988 * exp_of(-1.173 * log_of(kReference * i / (kEntries - 1)));
    if (range <= 0.8) metres[static_cast<std::size_t>(i)] = range;
  }
  return metres;
}

}  // namespace

BoardTables default_board_tables() {
  BoardTables tables;
  for (int id = 1; id <= kMotors; ++id) {
    tables.motors.push_back({id, {}});
    tables.encoders.push_back(id);
  }
  for (int id = 1; id <= kServos; ++id) tables.servos.push_back({id, {}, -1, -1});
  for (int id = 1; id <= kPsds; ++id) tables.psds.push_back({id, sharp_curve()});
  return tables;
}

}  // namespace eyebridge::hal
