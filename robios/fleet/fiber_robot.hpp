#pragma once

#include <utility>

#include "lockstep.hpp"
#include "robot.hpp"

namespace eyebridge::robios {

/// A robot in virtual time: a fiber of a Lockstep.
class FiberRobot final : public Robot {
 public:
  FiberRobot(std::size_t index, RobotProgram program, Lockstep& lockstep, AwaitedProcess& awaited)
      : Robot(index, std::move(program)), lockstep_(lockstep), awaited_(awaited) {}

  /// It comes when others run already, and nobody waits for it.
  void be_late() { has_come_ = true; }

  [[noreturn]] void hold_thread() override { lockstep_.drop_robot(); }
  void arrive() override {
    come();
    clock().wait_until(lockstep_.meet());
  }

 protected:
  [[noreturn]] void drop(int code) override {
    end(code);
    come();
    lockstep_.drop_robot();
  }
  [[nodiscard]] const Time* limit() const override { return &lockstep_.limit_of(index()); }
  AwaitedProcess* awaited() override { return &awaited_; }
  void forget() override {
    come();
    lockstep_.drop(index());
  }

 private:
  void come() {
    if (!std::exchange(has_come_, true)) lockstep_.count_in(now());
  }

  Lockstep& lockstep_;
  AwaitedProcess& awaited_;
  bool has_come_ = false;  ///< To where all wait for each other.
};

}  // namespace eyebridge::robios
