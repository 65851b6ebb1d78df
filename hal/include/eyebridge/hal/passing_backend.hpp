#pragma once

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

/// A backend around another one that passes on every question: a base for those that answer a few
/// differently.
class PassingBackend : public Backend {
 public:
  /// May be given later, before the first call: see inner_.
  explicit PassingBackend(std::unique_ptr<Backend> inner) : inner_(std::move(inner)) {}

  Clock& clock() override { return inner_->clock(); }
  void arrive() override { inner_->arrive(); }
  [[nodiscard]] int robot_id() const override { return inner_->robot_id(); }
  Device* find(DeviceKind kind, int id) override { return inner_->find(kind, id); }
  [[nodiscard]] RadioConditions radio_conditions() const override {
    return inner_->radio_conditions();
  }
  WorldControl* world() override { return inner_->world(); }
  Environment* environment() override { return inner_->environment(); }
  std::shared_ptr<SharedWorld> shared_world() override { return inner_->shared_world(); }
  HandGuide* hand_guide() override { return inner_->hand_guide(); }
  camera::View* camera_view() override { return inner_->camera_view(); }
  camera::Source* camera_source() override { return inner_->camera_source(); }
  camera::FrameSink* frame_sink() override { return inner_->frame_sink(); }
  std::string lost_results() override { return inner_->lost_results(); }
  std::vector<DeviceFacts> facts_of(std::string_view kind) override {
    return inner_->facts_of(kind);
  }
  void trace_to(TraceSink* sink) override { inner_->trace_to(sink); }
  Result<void> stop() noexcept override { return inner_->stop(); }

 protected:
  std::unique_ptr<Backend> inner_;
};

}  // namespace eyebridge::hal
