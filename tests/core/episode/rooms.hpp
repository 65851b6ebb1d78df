#pragma once

#include <memory>

#include "eyebridge/files/load.hpp"

namespace eyebridge::episode {

/// An empty room, 2 m x 2 m, and one S4 in its middle, to change.
inline std::shared_ptr<files::Scenario> room() {
  return std::make_shared<files::Scenario>(files::default_scenario());
}

/// The same, and the robot drives with errors that follow from the seed.
inline std::shared_ptr<files::Scenario> rough_room() {
  auto scenario = room();
  scenario->models[0].drive_error = {0.05, 0.05};
  return scenario;
}

}  // namespace eyebridge::episode
