#pragma once

#include <QPointF>
#include <memory>
#include <string>
#include <utility>

#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/environment.hpp"
#include "run_program.hpp"

namespace eyebridge::gui::testing {

/// A room of 2 x 1 m in virtual time, whose robot 1 stands at (500, 500) mm and looks along +x,
/// robot 2 at (1500, 500), and a can at (1000, 200).
class Room {
 public:
  /// `lines` are more of the world's file.
  explicit Room(const std::string& lines = "");
  /// Where its files lie.
  [[nodiscard]] std::string folder() const { return folder_.path(); }
  [[nodiscard]] hal::Environment& environment() { return *backend_->environment(); }
  [[nodiscard]] hal::Backend& robot() { return *backend_; }
  /// Robot 1 and the room with it, for good: nothing else here works any more.
  [[nodiscard]] std::unique_ptr<hal::Backend> take_robot() { return std::move(backend_); }
  [[nodiscard]] Pose pose(int robot);
  /// Time passes.
  void pass(double seconds);

 private:
  struct Silence final : LogSink {
    void write(Severity, std::string_view) override {}
  };
  eyebridge::testing::ScratchFolder folder_;
  Silence log_;
  std::unique_ptr<hal::Backend> backend_;
};

}  // namespace eyebridge::gui::testing
