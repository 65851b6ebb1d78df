#include <charconv>
#include <stdexcept>
#include <string>
#include <utility>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/url.hpp"
#include "eyebridge/camera/fiducials.hpp"
#include "render/engine.hpp"
#include "render/gl_context.hpp"
#include "sources/frame_errors.hpp"
#include "sources/frame_schedule.hpp"
#include "sources/sources.hpp"
#include "sources/stderr_log.hpp"

namespace eyebridge::camera {
namespace {

struct Settings {
  std::string maker;
  std::optional<FiducialFamily> fiducials{};
  double light = 1.0;
};

double read_light(const std::string& text) {
  double light = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), light);
  const bool all = error == std::errc{} && end == text.data() + text.size();
  if (all && light >= 0.01 && light <= 4.0) return light;
  throw ConfigError({"--camera"}, "render: found light=" + in_quotes(text) +
                                      ", expected a number 0.01 ... 4; 1 is usual");
}

/// "on" is the usual family, "off" none.
std::optional<FiducialFamily> read_fiducials(const std::string& value) {
  if (value == "off") return std::nullopt;
  if (value == "on") return FiducialFamily::Aruco5x5;
  if (const auto family = family_named(value)) return family;
  throw ConfigError({"--camera"}, "render: found fiducials=" + in_quotes(value) +
                                      ", expected on, off, " + std::string(kFamilyWords));
}

/// Of what follows "render:".
Settings read_settings(std::string_view rest) {
  const Url url = parse_url("render:" + std::string(rest), {"--camera"});
  Settings settings;
  settings.maker = url.rest;
  if (!settings.maker.empty()) check_gl_context_maker(settings.maker);
  for (const auto& [key, value] : url.options) {
    if (key == "light") {
      settings.light = read_light(value);
    } else if (key == "fiducials") {
      settings.fiducials = read_fiducials(value);
    } else {
      throw ConfigError({"--camera"}, "render: found the option " + in_quotes(key) +
                                          ", expected one of: fiducials, light");
    }
  }
  return settings;
}

class RenderSource final : public Source {
 public:
  RenderSource(Settings settings, const SourceContext& context)
      : settings_(std::move(settings)),
        clock_(*context.clock),
        view_(*context.view),
        log_(context.log) {
    // Now, so that a missing library is found while opening.
    RenderEngine::of_this_thread(settings_.maker, log_or_stderr(log_));
    if (settings_.fiducials) fiducial_bits(*settings_.fiducials, 0);
  }

  Result<void> set_size(int width, int height) override {
    return FrameSchedule::check_size(width, height).map([&] {
      width_ = width;
      height_ = height;
    });
  }

  [[nodiscard]] Size natural_size() const override { return {width_, height_}; }

  Result<FramePtr> next(Time deadline) override {
    const Result<FrameSlot> slot = schedule_.next(clock_, deadline);
    if (!slot) return tl::unexpected(slot.error());
    Shot shot;
    shot.scene = view_.scene();
    shot.eye = view_.eye();
    shot.carrier = view_.carrier();
    shot.texture_directory = view_.texture_directory();
    shot.fiducials = settings_.fiducials;
    shot.light = settings_.light;
    shot.width = width_;
    shot.height = height_;
    try {
      LogSink& log = log_or_stderr(log_);
      Frame frame = RenderEngine::of_this_thread(settings_.maker, log).render(shot, log);
      frame.time = slot->time;
      frame.sequence = slot->sequence;
      // By time: the sequence begins again with every source that is opened.
      errors_.apply(view_.noise(), static_cast<std::uint64_t>(frame.time.count()), frame);
      return std::make_shared<const Frame>(std::move(frame));
    } catch (const std::runtime_error& error) {
      return fail(Errc::Disconnected, std::string("render: ") + error.what());
    }
  }

 private:
  Settings settings_;
  Clock& clock_;
  View& view_;
  LogSink* log_;
  FrameSchedule schedule_;
  FrameErrors errors_;
  int width_ = 320;
  int height_ = 240;
};

}  // namespace

void check_render_source(std::string_view rest, const SourceContext& context) {
  if (context.view == nullptr) {
    throw ConfigError({"--camera"},
                      "render needs a simulated robot with a camera, and this robot has none");
  }
  const Settings settings = read_settings(rest);
  if (!settings.fiducials) return;
  try {
    place_fiducials(*context.view->scene().model, {.family = *settings.fiducials});
  } catch (const ConfigError& error) {
    throw ConfigError({"--camera"}, "render: " + error.text());
  }
}

std::unique_ptr<Source> open_render_source(std::string_view rest, const SourceContext& context) {
  return std::make_unique<RenderSource>(read_settings(rest), context);
}

}  // namespace eyebridge::camera
