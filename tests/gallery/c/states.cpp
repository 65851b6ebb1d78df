#include "eyebot++.h"
#include <iostream>
#include <map>
#include <string>
#include <functional>

/* A state machine with classes: patrol a room, flee from obstacles, rest, go home */
class Robot
{
public:
  enum State { PATROL, FLEE, REST, HOME, END };

  Robot() : state(PATROL), changes(0)
  {
    table[PATROL] = [this] { return patrol(); };
    table[FLEE]   = [this] { return flee(); };
    table[REST]   = [this] { return rest(); };
    table[HOME]   = [this] { return home(); };
    VWSetPosition(0, 0, 0);
  }

  void run()
  {
    static const char *names[] = {"PATROL", "FLEE", "REST", "HOME", "END"};
    while (state != END && KEYRead() != KEY4)
    {
      State next = table[state]();
      if (next != state) { changes++; std::cout << names[state] << " -> " << names[next] << std::endl; LCDPrintf("%s\n", names[next]); }
      state = next;
    }
  }
  int count() const { return changes; }

private:
  State patrol()
  {
    VWSetSpeed(200, 0);
    OSWait(100);
    if (PSDGet(PSD_FRONT) < 300) return FLEE;
    return OSGetCount() > 25000 ? HOME : PATROL;
  }
  State flee()
  {
    VWTurn(PSDGet(PSD_LEFT) > PSDGet(PSD_RIGHT) ? 110 : -110, 100);
    VWWait();
    return changes % 4 == 1 ? REST : PATROL;
  }
  State rest() { VWSetSpeed(0, 0); OSWait(2000); return PATROL; }
  State home()
  {
    int x, y, phi;
    VWGetPosition(&x, &y, &phi);
    if (hypot(x, y) < 50) return END;
    int a = int(atan2(-y, -x) * 180 / M_PI) - phi;
    if (a > 180) a -= 360;
    if (a < -180) a += 360;
    VWTurn(a, 90); VWWait();
    VWStraight(int(hypot(x, y)), 250); VWWait();
    return HOME;
  }

  State state;
  int changes;
  std::map<State, std::function<State()>> table;
};

int main()
{
  LCDMenu("", "", "", "END");
  Robot robot;
  robot.run();
  std::cout << robot.count() << " changes" << std::endl;
}
