#include "sources/erring_source.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/files/error_rules.hpp"
#include "sources/frame_errors.hpp"
#include "sources/url_option.hpp"

namespace eyebridge::camera {
namespace {

class ErringSource final : public Source {
 public:
  ErringSource(std::unique_ptr<Source> inner, const ImageNoise& noise)
      : inner_(std::move(inner)), noise_(noise) {}

  Result<void> set_size(int width, int height) override { return inner_->set_size(width, height); }
  [[nodiscard]] Size natural_size() const override { return inner_->natural_size(); }

  Result<FramePtr> next(Time deadline) override {
    Result<FramePtr> frame = inner_->next(deadline);
    if (!frame || noise_.error.perfect()) return frame;
    Frame erring = to_rgb24(**frame);
    errors_.apply(noise_, erring.sequence, erring);
    return std::make_shared<const Frame>(std::move(erring));
  }

 private:
  std::unique_ptr<Source> inner_;
  const ImageNoise noise_;
  FrameErrors errors_;
};

/// "harsh", or what follows `camera` in a rule with commas for blanks: "sigma=4,blur=1".
robot::CameraError read_errors(std::string text) {
  robot::RobotModel model;
  model.camera.emplace();
  const bool is_preset = robot::error_preset(text).has_value();
  std::replace(text.begin(), text.end(), ',', ' ');
  try {
    const std::string rule = is_preset ? text : "camera " + text;
    return files::with_errors(std::move(model), rule, 1.0).camera->error;
  } catch (const ConfigError& error) {
    throw ConfigError({"--camera"}, "errors=" + text + ": " + error.text());
  }
}

}  // namespace

ErringUrl take_errors(const std::string& url) {
  constexpr const char* kForm = "errors=harsh or errors=sigma=4,blur=1";
  const TakenOption errors = take_option(url, "errors", kForm);
  const TakenOption seed = take_option(errors.url, "error_seed", "error_seed=NUMBER");
  ErringUrl out{seed.url, std::nullopt};
  if (errors.value) out.noise = ImageNoise{read_errors(*errors.value)};
  if (!seed.value) return out;
  const char* const end = seed.value->data() + seed.value->size();
  std::uint64_t number = 0;
  const auto [stop, error] = std::from_chars(seed.value->data(), end, number);
  if (error != std::errc{} || stop != end || !out.noise) {
    throw ConfigError({"--camera"}, "found error_seed=" + in_quotes(*seed.value) +
                                        ", expected a whole number, beside errors=");
  }
  out.noise->seed = number;
  return out;
}

std::unique_ptr<Source> with_errors(std::unique_ptr<Source> inner, const ImageNoise& noise) {
  return std::make_unique<ErringSource>(std::move(inner), noise);
}

}  // namespace eyebridge::camera
