#include <stdexcept>
#include <string>

#include "eyebridge/base/config_error.hpp"
#include "render/engine.hpp"
#include "render/gl_context.hpp"
#include "render/noise.hpp"
#include "src/frame_schedule.hpp"
#include "src/sources.hpp"
#include "src/stderr_log.hpp"

namespace eyebridge::camera {
namespace {

class RenderSource final : public Source {
 public:
  RenderSource(std::string_view maker, const SourceContext& context)
      : maker_(maker), clock_(*context.clock), view_(*context.view), log_(context.log) {
    // Now, so that a missing library is found while opening.
    RenderEngine::of_this_thread(maker_, log_or_stderr(log_));
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
    const Shot shot{view_.scene(), view_.eye(), view_.carrier(), view_.texture_directory(),
                    width_,        height_};
    try {
      LogSink& log = log_or_stderr(log_);
      Frame frame = RenderEngine::of_this_thread(maker_, log).render(shot, log);
      frame.time = slot->time;
      frame.sequence = slot->sequence;
      noise_.apply(view_.noise(), frame);
      return std::make_shared<const Frame>(std::move(frame));
    } catch (const std::runtime_error& error) {
      return fail(Errc::Disconnected, std::string("render: ") + error.what());
    }
  }

 private:
  std::string maker_;
  Clock& clock_;
  View& view_;
  LogSink* log_;
  FrameSchedule schedule_;
  NoiseMaker noise_;
  int width_ = 320;
  int height_ = 240;
};

}  // namespace

void check_render_source(std::string_view rest, const SourceContext& context) {
  if (context.view == nullptr) {
    throw ConfigError({"--camera"},
                      "render needs a simulated robot with a camera, and this robot has none");
  }
  if (!rest.empty()) check_gl_context_maker(rest);
}

std::unique_ptr<Source> open_render_source(std::string_view rest, const SourceContext& context) {
  return std::make_unique<RenderSource>(rest, context);
}

}  // namespace eyebridge::camera
