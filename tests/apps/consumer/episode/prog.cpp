#include <cstdio>

#include "eyebridge/episode/batch.hpp"
#include "eyebridge/files/load.hpp"

int main() {
  using namespace eyebridge;
  const auto room = std::make_shared<files::Scenario>(files::default_scenario());
  episode::Episode one(room);
  one.simulation().set_speed(0, {0.3, 0.0});
  one.step_until([](const episode::Episode& e) { return e.simulation().pose(0).x > 1.2; }, 10);
  episode::EpisodeBatch many({room}, {.worlds = 3});
  std::printf("at %.1f, %zu rows\n", one.simulation().pose(0).x, many.rows().rewards.size());
}
