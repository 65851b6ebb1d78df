#include "v4l2/offers.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>

#include <linux/videodev2.h>

#include "v4l2/raw_formats.hpp"

namespace eyebridge::camera {
namespace {

// No camera has as many; a broken driver may list for ever.
constexpr std::uint32_t kMostOffers = 256;

Size make_size(std::uint32_t width, std::uint32_t height) {
  return {static_cast<int>(width), static_cast<int>(height)};
}

double rate_of(const v4l2_fract& interval) {
  return interval.numerator == 0
             ? 0.0
             : static_cast<double>(interval.denominator) / static_cast<double>(interval.numerator);
}

std::vector<OfferedSize> sizes_of(const VideoHandle& camera, std::uint32_t fourcc) {
  std::vector<OfferedSize> out;
  for (std::uint32_t index = 0; index < kMostOffers; ++index) {
    v4l2_frmsizeenum found{};
    found.index = index;
    found.pixel_format = fourcc;
    if (camera.control(VIDIOC_ENUM_FRAMESIZES, found) < 0) break;
    OfferedSize size;
    if (found.type == V4L2_FRMSIZE_TYPE_DISCRETE) {
      size.least = size.most = make_size(found.discrete.width, found.discrete.height);
      size.step = {1, 1};
    } else {
      size.least = make_size(found.stepwise.min_width, found.stepwise.min_height);
      size.most = make_size(found.stepwise.max_width, found.stepwise.max_height);
      size.step = make_size(std::max(1U, found.stepwise.step_width),
                            std::max(1U, found.stepwise.step_height));
    }
    if (size.least.width < 1 || size.least.height < 1 || size.most.width < size.least.width ||
        size.most.height < size.least.height) {
      continue;
    }
    size.rates = rates_of(camera, fourcc, size.most);
    out.push_back(std::move(size));
    if (found.type != V4L2_FRMSIZE_TYPE_DISCRETE) break;
  }
  return out;
}

/// The nearest of `least`, `least` + `step`, … `most` to `wanted`.
int nearest_step(int least, int most, int step, int wanted) {
  if (wanted <= least) return least;
  if (wanted >= most) return least + (most - least) / step * step;
  const int below = least + (wanted - least) / step * step;
  return wanted - below <= below + step - wanted || below + step > most ? below : below + step;
}

}  // namespace

Size OfferedSize::nearest(Size size) const {
  return {nearest_step(least.width, most.width, step.width, size.width),
          nearest_step(least.height, most.height, step.height, size.height)};
}

bool OfferedSize::has(Size size) const { return nearest(size) == size; }

std::vector<double> rates_of(const VideoHandle& camera, std::uint32_t fourcc, Size size) {
  std::vector<double> out;
  for (std::uint32_t index = 0; index < kMostOffers; ++index) {
    v4l2_frmivalenum found{};
    found.index = index;
    found.pixel_format = fourcc;
    found.width = static_cast<std::uint32_t>(size.width);
    found.height = static_cast<std::uint32_t>(size.height);
    if (camera.control(VIDIOC_ENUM_FRAMEINTERVALS, found) < 0) break;
    if (found.type == V4L2_FRMIVAL_TYPE_DISCRETE) {
      out.push_back(rate_of(found.discrete));
    } else {
      out.push_back(rate_of(found.stepwise.min));
      out.push_back(rate_of(found.stepwise.max));
      break;
    }
  }
  std::erase_if(out, [](double rate) { return !(rate > 0.0); });
  std::ranges::sort(out, std::greater());
  return out;
}

std::vector<OfferedFormat> offers_of(const VideoHandle& camera) {
  std::vector<OfferedFormat> out;
  for (std::uint32_t index = 0; index < kMostOffers; ++index) {
    v4l2_fmtdesc found{};
    found.index = index;
    found.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (camera.control(VIDIOC_ENUM_FMT, found) < 0) break;
    out.push_back({found.pixelformat, format_name(found.pixelformat),
                   raw_format_of(found.pixelformat) != nullptr,
                   sizes_of(camera, found.pixelformat)});
  }
  return out;
}

}  // namespace eyebridge::camera
