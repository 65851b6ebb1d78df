#include "board_rigs.hpp"

#include <utility>

#include "eyebridge/bridges/monotonic_clock.hpp"

namespace eyebridge::hal {

Rig io7_rig(const std::string& url, MakeStream line) {
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  const Config config = rig_config({{"hal", url}});
  auto clock = std::make_unique<bridges::MonotonicClock>();
  auto open = [line = std::move(line), &time = *clock] { return line(time); };
  rig.backend = open_io7_board(parse_backend_url(url, {"rig"}), {config, *rig.log}, std::move(open),
                               std::move(clock));
  return rig;
}

Rig can_rig(const std::string& url, const MakeBus& bus) {
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  const Config config = rig_config({{"hal", url}});
  auto clock = std::make_unique<bridges::MonotonicClock>();
  auto made = bus(*clock);
  rig.backend = open_can_board(parse_backend_url(url, {"rig"}), {config, *rig.log}, std::move(made),
                               std::move(clock));
  return rig;
}

}  // namespace eyebridge::hal
