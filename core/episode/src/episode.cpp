#include "eyebridge/episode/episode.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::episode {
namespace {

// Beyond those of the devices of all robots (core/robot/src/errors.cpp).
constexpr std::uint64_t kStartStream = std::uint64_t{1} << 63U;
constexpr int kTries = 10'000;

/// Puts robot 1 somewhere free.
void put_anywhere(robot::Simulation& simulation, std::uint64_t seed) {
  if (simulation.robot_count() == 0) {
    throw std::invalid_argument("found no robot, expected one to put anywhere");
  }
  const world::World& world = simulation.world();
  const world::BodyId body = simulation.body(0);
  Random random(seed, kStartStream);
  for (int i = 0; i < kTries; ++i) {
    const double x = random.uniform() * world.model().width;
    const double y = random.uniform() * world.model().height;
    const double theta = (2 * random.uniform() - 1) * kPi;
    if (!world.is_free({x, y}, world.radius(body), body)) continue;
    simulation.set_pose(0, {x, y, theta});
    return;
  }
  throw std::invalid_argument("the world has no room for robot 1");
}

}  // namespace

Episode::Episode(std::shared_ptr<const files::Scenario> scenario,
                 const robot::SimulationSettings& settings, Start start)
    : scenario_(std::move(scenario)),
      model_(scenario_, &scenario_->world),
      start_(start),
      settings_(settings) {
  begin();
}

Episode::~Episode() = default;

void Episode::begin() {
  // The new one is made before the last one goes: they share the index of the world's walls.
  simulation_ = robot::Simulation(model_, settings_);
  tally_ = {};
  total_reward_ = 0.0;
  for (const files::RobotPlacement& placed : scenario_->robots) {
    simulation_->add_robot(scenario_->models.at(placed.model), placed.pose);
  }
  if (start_ == Start::Anywhere) put_anywhere(*simulation_, settings_.seed);
  simulation_->on_collision(
      [this](const robot::CollisionEvent& event) { tally_.add_collision(event); });
}

void Episode::reset(std::uint64_t seed) {
  settings_.seed = seed;
  begin();
}

void Episode::set_reward(Reward reward) { reward_ = std::move(reward); }

void Episode::step() {
  simulation_->step();
  tally_.add_step(*simulation_);
  if (reward_) total_reward_ += reward_(*this);
}

bool Episode::step_until(const Condition& done, double seconds) {
  if (!(seconds >= 0 && seconds <= 1e9)) {
    throw std::invalid_argument("found " + std::to_string(seconds) +
                                " for the seconds to step, expected 0 ... 1e9");
  }
  long long left = std::max(std::llround(seconds / settings_.step), 1LL);
  do {
    step();
    if (done && done(*this)) return true;
  } while (--left > 0);
  return false;
}

}  // namespace eyebridge::episode
