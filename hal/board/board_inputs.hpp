#pragma once

#include <mutex>

#include "arguments/arguments.hpp"
#include "board/board_link.hpp"
#include "eyebridge/hal/analog_inputs.hpp"
#include "eyebridge/hal/io_board.hpp"
#include "eyebridge/hal/remote.hpp"

namespace eyebridge::hal {

/// The analog inputs of a board.
class BoardAnalog final : public AnalogInputs {
 public:
  explicit BoardAnalog(BoardLink& link) : link_(link) {}

  Result<int> read(int channel) override {
    return check_channel(channel).and_then([&] { return link_.analog(channel); });
  }
  Result<double> supply_voltage() override { return link_.supply_voltage(); }

 private:
  BoardLink& link_;
};

/// The board itself.
class BoardIdentity final : public IoBoard {
 public:
  explicit BoardIdentity(BoardLink& link) : link_(link) {}
  Result<std::string> version() override { return link_.version(); }

 private:
  BoardLink& link_;
};

/// The infrared receiver of a board, which says which key is held.
class BoardRemote final : public Remote {
 public:
  explicit BoardRemote(BoardLink& link) : link_(link) {}

  /// A key that is held is one press; the same key again is one after it was let go.
  Result<int> read() override {
    const std::lock_guard lock(mutex_);
    return link_.remote_key().map([&](int held) {
      const int before = held_;
      held_ = held;
      return held == before ? 0 : held;
    });
  }

 private:
  BoardLink& link_;
  std::mutex mutex_;
  int held_ = 0;
};

}  // namespace eyebridge::hal
