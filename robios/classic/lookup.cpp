#include "lookup.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "eyebridge/files/load.hpp"
#include "no_device.hpp"

namespace eyebridge::robios::classic {
namespace {

struct Row {
  std::string_view kind;
  std::string_view name;
  int semantics;
  int id;  ///< Where the robot's description says nothing; 0: there is none.
};

constexpr auto kTable = std::to_array<Row>({
    {"motor", "MOTOR_LEFT", MOTOR_LEFT, 1},
    {"motor", "MOTOR_RIGHT", MOTOR_RIGHT, 2},
    {"encoder", "QUAD_LEFT", QUAD_LEFT, 1},
    {"encoder", "QUAD_RIGHT", QUAD_RIGHT, 2},
    {"psd", "PSD_FRONT", PSD_FRONT, 1},
    {"psd", "PSD_LEFT", PSD_LEFT, 2},
    {"psd", "PSD_RIGHT", PSD_RIGHT, 3},
    {"psd", "PSD_BACK", PSD_BACK, 4},
    {"psd", "PSD_FRONTLEFT", PSD_FRONTLEFT, 5},
    {"psd", "PSD_FRONTRIGHT", PSD_FRONTRIGHT, 6},
    {"psd", "PSD_BACKLEFT", PSD_BACKLEFT, 7},
    {"psd", "PSD_BACKRIGHT", PSD_BACKRIGHT, 8},
    {"psd", "PSD_LEFTFRONT", PSD_LEFTFRONT, 0},
    {"psd", "PSD_LEFTBACK", PSD_LEFTBACK, 0},
    {"psd", "PSD_RIGHTFRONT", PSD_RIGHTFRONT, 0},
    {"psd", "PSD_RIGHTBACK", PSD_RIGHTBACK, 0},
    {"psd", "PSD_FRONT_HIGH", PSD_FRONT_HIGH, 0},
    {"psd", "PSD_FRONT_LOW", PSD_FRONT_LOW, 0},
    {"proximity", "IR_F", IR_F, 1},
    {"proximity", "IR_LF", IR_LF, 2},
    {"proximity", "IR_LM", IR_LM, 3},
    {"proximity", "IR_LB", IR_LB, 4},
    {"proximity", "IR_B", IR_B, 5},
    {"proximity", "IR_RF", IR_RF, 6},
    {"proximity", "IR_RM", IR_RM, 7},
    {"proximity", "IR_RB", IR_RB, 8},
    {"bumper", "BUMP_FRONT", BUMP_FRONT, 1},
    {"bumper", "BUMP_LEFT", BUMP_LEFT, 2},
    {"bumper", "BUMP_RIGHT", BUMP_RIGHT, 3},
    {"bumper", "BUMP_BACK", BUMP_BACK, 4},
    {"drive", "VW_DRIVE", VW_DRIVE, 1},
    {"drive", "VW", VW, 1},
    {"compass", "COMPASS", COMPASS, 1},
    {"remote", "IRTV", IRTV, 1},
});

constexpr int kServos = 16;

bool is_number(DeviceSemantics semantics) {
  return semantics >= std::numeric_limits<int>::min() &&
         semantics <= std::numeric_limits<int>::max();
}

std::string_view name_of(DeviceSemantics semantics) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr): C programs hand names over as numbers
  return reinterpret_cast<const char*>(semantics);
}

bool same(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::toupper(x) == std::toupper(y); });
}

const Row* row_of(int semantics) {
  const auto* row = std::ranges::find(kTable, semantics, &Row::semantics);
  return row == kTable.end() ? nullptr : row;
}

const Row* row_of(std::string_view name) {
  const auto* row = std::ranges::find_if(kTable, [&](const Row& r) { return same(r.name, name); });
  return row == kTable.end() ? nullptr : row;
}

/// The number at the end of "SERVO7", after `prefix`.
std::optional<int> number_after(std::string_view prefix, std::string_view name) {
  if (name.size() <= prefix.size() || !same(name.substr(0, prefix.size()), prefix)) return {};
  int number = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + prefix.size(), end, number);
  if (error != std::errc{} || stop != end || number < 0) return {};
  return number;
}

/// The names that the M6 numbers from 0; its servos count from 1 as everybody's do.
std::optional<int> m6_id(std::string_view kind, std::string_view name) {
  if (kind == "servo") return number_after("SERVO", name);
  std::optional<int> number;
  if (kind == "psd") number = number_after("PSD", name);
  if (kind == "encoder") number = number_after("ENCODER", name);
  if (kind == "motor") number = number_after("MOTOR", name);
  return number && *number < kServos ? std::optional(*number + 1) : std::nullopt;
}

/// What a device is called in messages.
std::string_view in_words(std::string_view kind) { return kind == "psd" ? "PSD" : kind; }

tl::unexpected<Error> none(hal::Backend& backend, std::string_view kind,
                           DeviceSemantics semantics) {
  const Row* const row =
      is_number(semantics) ? row_of(static_cast<int>(semantics)) : row_of(name_of(semantics));
  const bool is_psd = kind == "psd" && row != nullptr && row->kind == kind;
  return no_device(backend, fmt::format("{} {}", in_words(kind), describe(semantics)),
                   is_psd ? files::robots_with_psd(row->name) : std::vector<std::string>{});
}

}  // namespace

std::array<int, 2> vw_motors(hal::Backend& backend) {
  std::array<int, 2> ids{1, 2};
  for (const hal::DeviceFacts& motor : backend.facts_of("motor")) {
    if (same(motor.name, "MOTOR_LEFT")) ids[0] = motor.id;
    if (same(motor.name, "MOTOR_RIGHT")) ids[1] = motor.id;
  }
  return ids;
}

std::string describe(DeviceSemantics semantics) {
  if (!is_number(semantics)) return fmt::format("\"{:.60}\"", name_of(semantics));
  if (semantics <= SERVO1 && semantics > SERVO1 - kServos) {
    return fmt::format("{} (SERVO{})", semantics, SERVO1 - semantics + 1);
  }
  const Row* const row = row_of(static_cast<int>(semantics));
  return row == nullptr ? std::to_string(semantics) : fmt::format("{} ({})", semantics, row->name);
}

DeviceSemantics number_of(DeviceSemantics semantics) {
  if (is_number(semantics)) return semantics;
  const Row* const row = row_of(name_of(semantics));
  return row == nullptr ? UNKNOWN_SEMANTICS : row->semantics;
}

Result<int> find_device(hal::Backend& backend, std::string_view kind, DeviceSemantics semantics) {
  const bool numbered = is_number(semantics);
  const int number = numbered ? static_cast<int>(semantics) : 0;
  if (numbered && number == 0) return none(backend, kind, semantics);
  const Row* const row = numbered ? row_of(number) : row_of(name_of(semantics));
  if (row != nullptr && row->kind != kind) return none(backend, kind, semantics);
  const std::string_view name = !numbered        ? name_of(semantics)
                                : row != nullptr ? row->name
                                                 : std::string_view{};

  const std::vector<hal::DeviceFacts> facts = backend.facts_of(kind);
  for (const hal::DeviceFacts& device : facts) {
    if (!name.empty() && same(device.name, name)) return device.id;
  }
  for (const hal::DeviceFacts& device : facts) {
    if (numbered && device.semantics == number) return device.id;
  }
  if (!numbered) {
    if (const auto id = m6_id(kind, name)) return *id;
  } else if (kind == "servo" && number < SERVO1 + 1 && number >= SERVO1 + 1 - kServos) {
    return SERVO1 - number + 1;
  }
  if (facts.empty() && row != nullptr && row->id != 0) return row->id;
  return none(backend, kind, semantics);
}

}  // namespace eyebridge::robios::classic
