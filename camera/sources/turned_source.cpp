#include "sources/turned_source.hpp"

#include <algorithm>
#include <array>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "pictures/turn.hpp"
#include "sources/url_option.hpp"

namespace eyebridge::camera {
namespace {

class TurnedSource final : public Source {
 public:
  TurnedSource(std::unique_ptr<Source> inner, int orientation)
      : inner_(std::move(inner)), orientation_(orientation) {}

  Result<void> set_size(int width, int height) override {
    const Size asked = upright_size({width, height}, orientation_);
    return inner_->set_size(asked.width, asked.height);
  }

  [[nodiscard]] Size natural_size() const override {
    return upright_size(inner_->natural_size(), orientation_);
  }

  Result<FramePtr> next(Time deadline) override {
    return inner_->next(deadline).map([this](const FramePtr& frame) -> FramePtr {
      return std::make_shared<const Frame>(upright(*frame, orientation_));
    });
  }

 private:
  std::unique_ptr<Source> inner_;
  const int orientation_;
};

/// Exif's orientation for quarter turns clockwise, then for a mirrored picture: not, h, v.
constexpr std::array<std::array<int, 3>, 4> kOrientations = {
    {{1, 2, 4}, {6, 5, 7}, {3, 4, 2}, {8, 7, 5}}};
constexpr std::array<std::string_view, 4> kTurns = {"0", "90", "180", "270"};
constexpr std::array<std::string_view, 3> kFlips = {"", "h", "v"};

}  // namespace

MountedUrl take_mounting(const std::string& url) {
  const TakenOption rotate = take_option(url, "rotate", "rotate=90");
  const TakenOption flip = take_option(rotate.url, "flip", "flip=h");
  const auto index_of = [](const auto& words, const std::string& word, const char* expected) {
    const auto found = std::ranges::find(words, word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    throw ConfigError({"--camera"}, "found " + in_quotes(word) + ", expected " + expected);
  };
  const std::size_t turns =
      index_of(kTurns, rotate.value.value_or("0"), "rotate=90, 180 or 270, clockwise");
  const std::size_t mirror = index_of(kFlips, flip.value.value_or(""), "flip=h or flip=v");
  return {flip.url, kOrientations[turns][mirror]};
}

std::unique_ptr<Source> turned(std::unique_ptr<Source> inner, int orientation) {
  return std::make_unique<TurnedSource>(std::move(inner), orientation);
}

}  // namespace eyebridge::camera
