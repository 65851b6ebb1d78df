#include "psd_kinds.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "eyebridge/base/units.hpp"

namespace eyebridge::files {
namespace {

// In the order of robot::RangeKind.
constexpr std::array<std::string_view, 4> kPsdKinds = {"ray", "ultrasound", "infrared", "down"};

/// ID of "ultrasound:ID".
int read_sensor_number(const Statement& s, std::string_view word) {
  int number = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error == std::errc{} && stop == end && number >= 1) return number;
  s.fail(1, in_quotes(word) + " found: expected the number of a psd, 1 or more");
}

}  // namespace

std::pair<double, double> read_range_limits(const Statement& s, std::size_t first) {
  const double low = s.millimetres(first, "the shortest range", 0, 1e5);
  const double high = s.millimetres(first + 1, "the longest range", 0, 1e5);
  if (high <= low) s.fail(first + 1, "the longest range is not above the shortest");
  return {low, high};
}

PsdKind read_psd_kind(const Statement& s) {
  if (s.size() < 2) s.fail(1, "line ends: expected " + one_of(kPsdKinds));
  const std::string word = lower(s.text(1));
  const std::size_t colon = std::min(word.find(':'), word.size());
  const auto found = std::find(kPsdKinds.begin(), kPsdKinds.end(), word.substr(0, colon));
  if (found == kPsdKinds.end()) {
    const std::string_view near = nearest(word.substr(0, colon), kPsdKinds);
    s.fail(1, "unknown kind of psd " + in_quotes(s.text(1)) + ": expected " +
                  (near.empty() ? one_of(kPsdKinds) : in_quotes(near) + "?"));
  }
  PsdKind kind;
  kind.where = s.where(1);
  kind.kind = static_cast<robot::RangeKind>(found - kPsdKinds.begin());
  if (colon < word.size()) kind.id = read_sensor_number(s, s.text(1).substr(colon + 1));
  switch (kind.kind) {
    case robot::RangeKind::Ray:
      s.expect_arguments(1, "psd_kind ray[:ID]");
      break;
    case robot::RangeKind::Ultrasound:
      s.expect_arguments({3, 5}, "psd_kind ultrasound[:ID] beam_deg critical_deg min_mm max_mm");
      kind.ultrasound.beam_width = deg_to_rad(s.number(2, "the width of the beam", 0, 180));
      kind.ultrasound.critical_angle = deg_to_rad(s.number(3, "the critical angle", 0, 90));
      if (s.size() == 6) kind.range = read_range_limits(s, 4);
      break;
    case robot::RangeKind::Infrared:
      s.expect_arguments(3, "psd_kind infrared[:ID] min_mm max_mm");
      kind.range = read_range_limits(s, 2);
      break;
    case robot::RangeKind::Down:
      s.expect_arguments(1, "psd_kind down[:ID]");
      break;
  }
  return kind;
}

void apply_psd_kind(const PsdKind& kind, robot::RobotModel& model) {
  std::string known;
  bool applied = false;
  for (robot::RangeSensorModel& psd : model.range_sensors) {
    known += (known.empty() ? "" : ", ") + std::to_string(psd.id);
    if (kind.id && *kind.id != psd.id) continue;
    applied = true;
    psd.kind = kind.kind;
    psd.ultrasound = kind.ultrasound;
    if (kind.range) {
      psd.min_range = kind.range->first;
      psd.max_range = kind.range->second;
    }
  }
  if (applied || !kind.id) return;
  throw ConfigError(kind.where,
                    "robot " + in_quotes(model.name) + " has no psd " + std::to_string(*kind.id) +
                        ": expected " +
                        (known.empty() ? "a psd line, it has none" : "one of " + known));
}

}  // namespace eyebridge::files
