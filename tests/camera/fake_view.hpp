#pragma once

#include <memory>
#include <string>
#include <vector>

#include "eyebridge/base/log.hpp"
#include "eyebridge/camera/view.hpp"

namespace eyebridge::camera::testing {

/// A world and an eye that a test sets as it likes.
class FakeView final : public View {
 public:
  [[nodiscard]] world::Scene scene() const override {
    // One copy as long as nothing changes, as in a simulation: a renderer keeps what it made of it.
    if (!copy_ || *copy_ != model) copy_ = std::make_shared<const world::WorldModel>(model);
    world::Scene scene;
    scene.model = copy_;
    scene.bodies = bodies;
    return scene;
  }
  [[nodiscard]] Eye eye() const override { return eye_; }
  [[nodiscard]] std::uint32_t carrier() const override { return carrier_; }
  [[nodiscard]] ImageNoise noise() const override { return noise_; }
  [[nodiscard]] std::string texture_directory() const override { return directory; }

  world::WorldModel model;
  std::vector<world::BodyView> bodies;
  Eye eye_;
  std::uint32_t carrier_ = 0;
  ImageNoise noise_;
  std::string directory;

 private:
  mutable std::shared_ptr<const world::WorldModel> copy_;
};

/// Keeps what was written to it.
class RecordingLog final : public LogSink {
 public:
  void write(Severity severity, std::string_view message) override {
    if (severity >= Severity::Warning) warnings.emplace_back(message);
  }
  std::vector<std::string> warnings;
};

}  // namespace eyebridge::camera::testing
