// potential field: the goal pulls, every lidar point pushes
#include <vector>
#include <utility>
#include "eyebot++.h"
#include "eyebot.h"

using Vec = std::pair<double, double>;

constexpr int GOAL_X = 4600, GOAL_Y = 1000;

static Vec force(int x, int y, int phi)
{
  std::vector<int> scan(LIDAR_RESOLUTION);
  LIDARGet(scan.data());
  double gx = GOAL_X - x, gy = GOAL_Y - y, g = sqrt(gx * gx + gy * gy);
  Vec f{gx / g, gy / g};
  for (size_t i = 0; i < scan.size(); i += 4)
  {
    double d = scan[i];
    if (d > 450) continue;
    double a = (180.0 - i + phi) * M_PI / 180;
    double push = 0.02 * (450 - d) / 100;
    f.first -= push * cos(a);
    f.second -= push * sin(a);
  }
  return f;
}

int main()
{
  int x = 0, y = 0, z, phi, steps = 0;
  LCDMenu("", "", "", "END");
  LCDArea(20, 60, 520, 260, NAVY, 1);
  LCDCircle(20 + GOAL_X / 10, 260 - GOAL_Y / 10, 6, GREEN, 1);
  do
  {
    SIMGetRobot(0, &x, &y, &z, &phi);
    LCDCircle(20 + x / 10, 260 - y / 10, 1, YELLOW, 1);
    auto [fx, fy] = force(x, y, phi);
    int a = static_cast<int>(atan2(fy, fx) * 180 / M_PI) - phi;
    while (a > 180) a -= 360;
    while (a < -180) a += 360;
    if (abs(a) > 70) VWSetSpeed(0, a);
    else VWSetSpeed(150 - abs(a), a);
    OSWait(50);
  } while (hypot(GOAL_X - x, GOAL_Y - y) > 100 && ++steps < 1200 && KEYRead() != KEY4);
  VWSetSpeed(0, 0);
  printf("%s\n", steps < 1200 ? "at the goal" : "stuck");
  LCDSetPrintf(1, 0, "after %d steps at %d %d", steps, x, y);
}
