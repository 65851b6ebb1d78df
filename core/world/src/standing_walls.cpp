#include "standing_walls.hpp"

#include <map>
#include <mutex>
#include <utility>

#include "ray_grid.hpp"

namespace eyebridge::world {

StandingWalls::StandingWalls(std::shared_ptr<const WorldModel> world_model)
    : model(std::move(world_model)),
      index(model->walls),
      rays(*model),
      by_sweep(rays.method() != RayMethod::EdgeBits),
      near(by_sweep ? outlines_of(model->walls) : std::vector<Segment>{}) {}

std::shared_ptr<const StandingWalls> StandingWalls::of(std::shared_ptr<const WorldModel> model) {
  // An entry that has not expired keeps its model alive: its address is not used again.
  static std::mutex mutex;
  static std::map<const WorldModel*, std::weak_ptr<const StandingWalls>> known;
  const std::lock_guard lock(mutex);
  if (const auto found = known.find(model.get()); found != known.end()) {
    if (auto there = found->second.lock()) return there;
  }
  std::erase_if(known, [](const auto& entry) { return entry.second.expired(); });
  std::weak_ptr<const StandingWalls>& place = known[model.get()];
  auto made = std::make_shared<const StandingWalls>(std::move(model));
  place = made;
  return made;
}

}  // namespace eyebridge::world
