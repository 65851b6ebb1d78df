#include <algorithm>
#include <array>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/convert.hpp"
#include "sources/frame_schedule.hpp"
#include "sources/sources.hpp"

namespace eyebridge::camera {
namespace {

constexpr std::array<Rgb, 8> kBars{{{255, 255, 255},
                                    {255, 255, 0},
                                    {0, 255, 255},
                                    {0, 255, 0},
                                    {255, 0, 255},
                                    {255, 0, 0},
                                    {0, 0, 255},
                                    {0, 0, 0}}};
constexpr int kDigits = 16;  // of the frame's number, binary

/// What is to be seen at (x, y): bars above; below them the frame's number, highest digit left, and
/// in the last rows a white block that moves a sixteenth to the right with each frame.
Rgb pixel_at(int x, int y, int width, int height, std::uint64_t sequence) {
  constexpr Rgb kWhite{255, 255, 255};
  constexpr Rgb kBlack{0, 0, 0};
  if (y < height * 3 / 4) return kBars[static_cast<std::size_t>(x * 8 / width)];
  const int place = x * kDigits / width;
  if (y < height * 7 / 8) return ((sequence >> (kDigits - 1 - place)) & 1U) != 0 ? kWhite : kBlack;
  return place == static_cast<int>(sequence % kDigits) ? kWhite : Rgb{64, 64, 64};
}

class PatternSource final : public Source {
 public:
  explicit PatternSource(Clock& clock) : clock_(clock) {}

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
    Frame frame = make_frame(width_, height_, PixelFormat::Rgb24);
    frame.time = slot->time;
    frame.sequence = slot->sequence;
    auto out = frame.bytes.begin();
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const Rgb colour = pixel_at(x, y, width_, height_, slot->sequence);
        *out++ = colour.r;
        *out++ = colour.g;
        *out++ = colour.b;
      }
    }
    return std::make_shared<const Frame>(std::move(frame));
  }

 private:
  Clock& clock_;
  FrameSchedule schedule_;
  int width_ = 320;
  int height_ = 240;
};

}  // namespace

void check_pattern_source(std::string_view rest, const SourceContext&) {
  if (rest.empty()) return;
  throw ConfigError({"--camera"}, "pattern takes nothing after the colon, found \"pattern:" +
                                      std::string(rest) + "\"");
}

std::unique_ptr<Source> open_pattern_source(std::string_view, const SourceContext& context) {
  return std::make_unique<PatternSource>(*context.clock);
}

}  // namespace eyebridge::camera
