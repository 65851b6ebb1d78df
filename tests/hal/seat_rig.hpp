#pragma once

#include <memory>
#include <thread>
#include <utility>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/hal/seat_desk.hpp"
#include "rigs.hpp"
#include "seat/seat_robot.hpp"

namespace eyebridge::hal {

/// Both ends of a line between two processes; here in one.
std::pair<UniqueFd, UniqueFd> socket_pair();

/// For robots whose camera nobody asks.
std::shared_ptr<const world::WorldModel> no_world();

/// A robot at its seat, which a thread of its own answers for.
class Seated {
 public:
  Seated(Rig rig, UniqueFd line);
  ~Seated();
  Seated(const Seated&) = delete;
  Seated& operator=(const Seated&) = delete;
  /// Closes the line.
  void end();

 private:
  Rig rig_;
  UniqueFd line_;
  std::thread thread_;
};

/// A seat and its program's end.
struct SeatRig {
  std::unique_ptr<Seated> seat;
  std::unique_ptr<Backend> robot;

  void end() const { seat->end(); }
};

SeatRig seat_rig(const Pose& start,
                 const std::map<std::string, std::string>& flags = {{"fast", "true"}});

}  // namespace eyebridge::hal
