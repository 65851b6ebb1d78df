#pragma once

#include <memory>

#include "eyebridge/camera/view.hpp"
#include "eyebridge/hal/backend.hpp"
#include "mix/pose_tracker.hpp"

namespace eyebridge::hal {

/// How one backend of a mixture keeps up with the others; what is not null is lent.
struct Follow {
  Clock* clock = nullptr;          ///< The program's, when the backend has one of its own.
  WorldControl* world = nullptr;   ///< The backend's, when its robot is driven elsewhere.
  PoseTracker* tracker = nullptr;  ///< Where that robot is. Never null.
  bool leads = false;              ///< The drive that the tracker asks is this backend's.
};

/// `inner`, which before each call to a device is brought to the program's time and place.
/// Without gyroscope and accelerometer where its robot is put somewhere and does not drive.
std::unique_ptr<Backend> make_following(std::unique_ptr<Backend> inner, const Follow& follow);

/// The camera's view of `backend`, which both lends, brought likewise before each look; null when
/// it has none.
std::unique_ptr<camera::View> make_following_view(Backend& backend, const Follow& follow);

}  // namespace eyebridge::hal
