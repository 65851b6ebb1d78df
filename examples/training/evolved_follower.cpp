// Drives once round a corridor by a wall law that was evolved (evolve_wall_follower prints it): a
// robot program like any other, which knows nothing of the training.
//
// Usage: evolved_follower KEEP GAIN DAMPING SPEED FRONT_STOP TURN, in metres, radians and seconds

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "eyebot.h"
#include "wall_law.hpp"

namespace {

constexpr int kNear_mm = 250;
constexpr int kGiveUp_ms = 120'000;
constexpr double kDegrees = 57.29577951308232;  // in a radian

/// Back where it started, by odometry, after it was away.
bool back_again(bool& was_away) {
  int x = 0;
  int y = 0;
  int phi = 0;
  VWGetPosition(&x, &y, &phi);
  const double away = std::hypot(x, y);
  was_away = was_away || away > 8 * kNear_mm;
  return was_away && away < kNear_mm;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 1 + WallLaw::kGenes) {
    std::fprintf(stderr, "found %d numbers, expected keep gain damping speed front_stop turn\n",
                 argc - 1);
    return 2;
  }
  WallLaw law;
  for (int i = 0; i < WallLaw::kGenes; ++i) law.genes[i] = std::atof(argv[i + 1]);

  double last_side = PSDGet(PSD_RIGHT) / 1000.0;
  bool was_away = false;
  while (!back_again(was_away) && OSGetCount() < kGiveUp_ms) {
    const double side = PSDGet(PSD_RIGHT) / 1000.0;
    const WallLaw::Command command = law.steer(PSDGet(PSD_FRONT) / 1000.0, side, last_side);
    last_side = side;
    VWSetSpeed(static_cast<int>(std::lround(command.linear * 1000)),
               static_cast<int>(std::lround(command.angular * kDegrees)));
    OSWait(static_cast<int>(WallLaw::kPeriod * 1000));
  }
  VWSetSpeed(0, 0);
  const bool finished = OSGetCount() < kGiveUp_ms;
  std::printf("result finished %d\n", finished ? 1 : 0);
  std::printf("result seconds %.1f\n", OSGetCount() / 1000.0);
  return finished ? 0 : 1;
}
