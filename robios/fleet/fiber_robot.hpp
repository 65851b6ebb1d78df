#pragma once

#include <utility>

#include "lockstep.hpp"
#include "robot.hpp"
#include "strands.hpp"

namespace eyebridge::robios {

/// A robot in virtual time: its flows are strands of a Lockstep.
class FiberRobot final : public Robot {
 public:
  FiberRobot(std::size_t index, RobotProgram program, Lockstep& lockstep, Strands& strands,
             AwaitedProcess& awaited)
      : Robot(index, std::move(program)),
        lockstep_(lockstep),
        strands_(strands),
        awaited_(awaited) {}

  [[noreturn]] void leave(int code) override {
    end(code);
    strands_.forget(index());
    lockstep_.drop_robot();
  }
  [[noreturn]] void hold_thread() override { lockstep_.drop_strand(); }
  void arrive() override {}  // virtual time begins for all at once

 protected:
  [[nodiscard]] const Time* limit() const override { return &lockstep_.limit_of(index()); }
  AwaitedProcess* awaited() override { return &awaited_; }
  void forget() override {
    strands_.forget(index());
    lockstep_.drop(index());
  }

 private:
  Lockstep& lockstep_;
  Strands& strands_;
  AwaitedProcess& awaited_;
};

}  // namespace eyebridge::robios
