#include "v4l2/mode.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>

#include <linux/videodev2.h>

#include "eyebridge/base/config_error.hpp"
#include "v4l2/open_errors.hpp"

namespace eyebridge::camera {
namespace {

constexpr Size kUsualSize{640, 480};
constexpr double kUsualRate = 30.0;
// 29.97 passes for 30.
constexpr double kRateTolerance = 0.02;

bool is_about(double rate, double wanted) {
  return std::abs(rate - wanted) <= kRateTolerance * wanted;
}

double distance(Size a, Size b) {
  const double x = a.width - b.width;
  const double y = a.height - b.height;
  return std::sqrt(x * x + y * y);
}

/// The nearest sizes that are offered, a few, nearest first.
std::vector<Size> nearest_sizes(const std::vector<OfferedSize>& offered, Size wanted) {
  constexpr std::size_t kFew = 4;
  std::vector<Size> out;
  for (const OfferedSize& sizes : offered) out.push_back(sizes.nearest(wanted));
  std::ranges::sort(out, {}, [&](Size size) { return distance(size, wanted); });
  out.erase(std::unique(out.begin(), out.end()), out.end());
  if (out.size() > kFew) out.resize(kFew);
  return out;
}

template <class Items, class Text>
std::string listed(const Items& items, Text text) {
  std::string out;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) out += i + 1 == items.size() ? " and " : ", ";
    out += text(items[i]);
  }
  return out;
}

/// How good the best rate of `size` is: 0 when nothing faster than wanted is missing, else less.
double shortfall(const std::vector<double>& rates, double wanted) {
  if (rates.empty() || rates.front() >= wanted * (1.0 - kRateTolerance)) return 0.0;
  return rates.front() - wanted;
}

double chosen_rate(const std::vector<double>& rates, double wanted) {
  if (rates.empty()) return wanted;
  // The slowest that is fast enough: a camera's highest rate may cost light and USB bandwidth.
  double best = rates.front();
  for (const double rate : rates) {
    if (rate >= wanted * (1.0 - kRateTolerance)) best = rate;
  }
  return best;
}

bool is_read_as(const OfferedFormat& offer, const std::optional<std::string>& name) {
  return offer.is_read && (!name || offer.name == *name);
}

[[noreturn]] void refuse_size(const VideoHandle& camera, const std::vector<OfferedFormat>& offers,
                              const CameraUrl& wanted) {
  std::vector<OfferedSize> sizes;
  std::vector<OfferedFormat> named;
  for (const OfferedFormat& offer : offers) {
    if (!is_read_as(offer, wanted.format)) continue;
    named.push_back(offer);
    sizes.insert(sizes.end(), offer.sizes.begin(), offer.sizes.end());
  }
  throw camera_error(camera.path(), "it does not offer " + to_text(*wanted.size) + " in " +
                                        listed_formats(named) + "; nearest are " +
                                        listed(nearest_sizes(sizes, *wanted.size), to_text));
}

void check_rate(const VideoHandle& camera, const Mode& mode, const std::vector<double>& rates,
                double wanted) {
  const bool reached = rates.empty() || std::ranges::any_of(rates, [&](double rate) {
                         return is_about(rate, wanted);
                       });
  if (reached) return;
  throw camera_error(camera.path(), "it does not offer " + rate_text(wanted) +
                                        " frames a second at " + to_text(mode.size) + " in " +
                                        format_name(mode.fourcc) + ", only " +
                                        listed(rates, rate_text));
}

/// Undoes what an earlier program may have left: a picture that fills a part of the frame only. Few
/// drivers know of it; the others refuse, and that is well.
void fill_frame(const VideoHandle& camera, Size size) {
  v4l2_selection whole{};
  whole.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  whole.target = V4L2_SEL_TGT_COMPOSE;
  whole.r.width = static_cast<std::uint32_t>(size.width);
  whole.r.height = static_cast<std::uint32_t>(size.height);
  static_cast<void>(camera.control(VIDIOC_S_SELECTION, whole));
}

}  // namespace

std::string to_text(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

std::string rate_text(double fps) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", fps);
  return text;
}

std::string listed_formats(const std::vector<OfferedFormat>& offers) {
  return offers.empty() ? "none" : listed(offers, [](const OfferedFormat& o) { return o.name; });
}

Mode choose_mode(const VideoHandle& camera, const std::vector<OfferedFormat>& offers,
                 const CameraUrl& wanted) {
  const Size size = wanted.size.value_or(kUsualSize);
  const double fps = wanted.fps.value_or(kUsualRate);
  std::optional<Mode> best;
  std::vector<double> best_rates;
  double best_shortfall = 0.0;
  bool has_format = false;
  for (const RawFormatName& known : kRawFormats) {
    for (const OfferedFormat& offer : offers) {
      if (offer.fourcc != known.fourcc || !is_read_as(offer, wanted.format)) continue;
      has_format = true;
      Mode mode{offer.fourcc, known.format, size};
      if (!offer.sizes.empty()) mode.size = nearest_sizes(offer.sizes, size).front();
      if (wanted.size && mode.size != size) continue;
      std::vector<double> rates = rates_of(camera, offer.fourcc, mode.size);
      const double missing = shortfall(rates, fps);
      if (best && missing <= best_shortfall) continue;
      mode.fps = chosen_rate(rates, fps);
      best = mode;
      best_rates = std::move(rates);
      best_shortfall = missing;
    }
  }
  if (!has_format) {
    throw camera_error(camera.path(), "it does not offer " + wanted.format.value_or("") +
                                          ", only " + listed_formats(offers));
  }
  if (!best) refuse_size(camera, offers, wanted);
  if (wanted.fps) check_rate(camera, *best, best_rates, *wanted.fps);
  return *best;
}

Mode set_mode(const VideoHandle& camera, Mode mode, bool rate_matters) {
  v4l2_format format{};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  format.fmt.pix.width = static_cast<std::uint32_t>(mode.size.width);
  format.fmt.pix.height = static_cast<std::uint32_t>(mode.size.height);
  format.fmt.pix.pixelformat = mode.fourcc;
  format.fmt.pix.field = V4L2_FIELD_ANY;
  if (const int result = camera.control(VIDIOC_S_FMT, format); result < 0) {
    throw call_error(camera.path(), "setting the format", -result);
  }
  const Size got{static_cast<int>(format.fmt.pix.width), static_cast<int>(format.fmt.pix.height)};
  if (format.fmt.pix.pixelformat != mode.fourcc || got != mode.size) {
    throw camera_error(camera.path(), "it makes " + to_text(got) + " " +
                                          format_name(format.fmt.pix.pixelformat) + " of " +
                                          to_text(mode.size) + " " + format_name(mode.fourcc));
  }
  if (format.fmt.pix.field == V4L2_FIELD_ALTERNATE) {
    throw camera_error(camera.path(),
                       "it sends half pictures (alternate fields), expected whole "
                       "ones");
  }
  mode.stride = static_cast<int>(format.fmt.pix.bytesperline);
  fill_frame(camera, mode.size);

  v4l2_streamparm parameters{};
  parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (camera.control(VIDIOC_G_PARM, parameters) < 0) {
    mode.fps = 0.0;  // a driver without rates
    return mode;
  }
  v4l2_fract& interval = parameters.parm.capture.timeperframe;
  if ((parameters.parm.capture.capability & V4L2_CAP_TIMEPERFRAME) != 0) {
    constexpr std::uint32_t kScale = 1000;
    interval = {kScale, static_cast<std::uint32_t>(std::lround(mode.fps * kScale))};
    if (const int result = camera.control(VIDIOC_S_PARM, parameters); result < 0) {
      throw call_error(camera.path(), "setting the frame rate", -result);
    }
  }
  const double rate = interval.numerator == 0 ? 0.0
                                              : static_cast<double>(interval.denominator) /
                                                    static_cast<double>(interval.numerator);
  if (rate_matters && rate > 0.0 && !is_about(rate, mode.fps)) {
    throw camera_error(camera.path(), "it sends " + rate_text(rate) + " frames a second, not " +
                                          rate_text(mode.fps));
  }
  mode.fps = rate;
  return mode;
}

}  // namespace eyebridge::camera
