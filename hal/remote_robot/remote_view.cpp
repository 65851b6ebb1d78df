#include "remote_robot/remote_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace eyebridge::hal {
namespace {

constexpr std::size_t kPerBody = 11;    // numbers, the last one how many corners follow: x, y
constexpr double kHalf = 4294967296.0;  // 2^32: a seed is told in two halves

/// `value` as a whole number 0 … `most`.
double whole(double value, double most) {
  return std::isnan(value) ? 0.0 : std::floor(std::clamp(value, 0.0, most));
}

Rgb colour_of(const double* v) {
  const auto channel = [](double value) { return static_cast<std::uint8_t>(whole(value, 255.0)); };
  return {channel(v[0]), channel(v[1]), channel(v[2])};
}

Result<Values> look(RobotLine& line, const char* what) {
  return line.ask({"view", 1, what, false, {}});
}

}  // namespace

Values pack_scene(const world::Scene& scene) {
  Values values{scene.time};
  values.reserve(1 + kPerBody * scene.bodies.size());
  for (const world::BodyView& b : scene.bodies) {
    const std::array<double, kPerBody> body = {
        static_cast<double>(b.id),
        static_cast<double>(b.shape),
        b.pose.x,
        b.pose.y,
        b.pose.theta,
        b.radius,
        b.height,
        static_cast<double>(b.colour.r),
        static_cast<double>(b.colour.g),
        static_cast<double>(b.colour.b),
        b.corners ? static_cast<double>(b.corners->size()) : 0.0};
    values.insert(values.end(), body.begin(), body.end());
    if (!b.corners) continue;
    for (const Vec2 corner : *b.corners) values.insert(values.end(), {corner.x, corner.y});
  }
  return values;
}

bool unpack_scene(const Values& values, world::Scene& scene) {
  if (values.empty()) return false;
  std::vector<world::BodyView> bodies;
  for (std::size_t at = 1; at < values.size();) {
    if (values.size() - at < kPerBody) return false;
    const double* const v = values.data() + at;
    at += kPerBody;
    world::BodyView& body = bodies.emplace_back();
    body.id = static_cast<std::uint32_t>(whole(v[0], kHalf - 1));
    body.shape = static_cast<world::BodyShape>(static_cast<int>(whole(v[1], 3.0)));
    body.pose = {v[2], v[3], v[4]};
    body.radius = v[5];
    body.height = v[6];
    body.colour = colour_of(v + 7);
    const auto count = static_cast<std::size_t>(whole(v[10], world::kMostCorners));
    const bool is_polygon = body.shape == world::BodyShape::Polygon;
    if ((values.size() - at) / 2 < count || (is_polygon ? count < 3 : count > 0)) return false;
    if (!is_polygon) continue;
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < count; ++i, at += 2) {
      corners.push_back({values[at], values[at + 1]});
    }
    body.corners = std::make_shared<const std::vector<Vec2>>(std::move(corners));
  }
  scene.time = values.front();
  scene.bodies = std::move(bodies);
  return true;
}

Values pack_eye(const camera::Eye& eye) {
  return {eye.x, eye.y, eye.z, eye.heading, eye.pitch, eye.horizontal_field_of_view};
}

Values pack_noise(const camera::ImageNoise& noise) {
  const robot::CameraError& error = noise.error;
  return {error.salt_and_pepper,
          error.sigma,
          error.coloured,
          error.blur,
          error.exposure,
          error.exposure_sigma,
          static_cast<double>(noise.seed >> 32U),
          static_cast<double>(noise.seed & 0xFFFFFFFFU)};
}

world::Scene RemoteView::scene() const {
  const Result<Values> bodies = look(line_, "scene");
  const std::lock_guard lock(mutex_);
  if (last_.model == nullptr) last_.model = load_();
  if (bodies) static_cast<void>(unpack_scene(*bodies, last_));
  return last_;
}

camera::Eye RemoteView::eye() const {
  const Result<Values> v = look(line_, "eye");
  const std::lock_guard lock(mutex_);
  if (v && v->size() == 6) last_eye_ = {(*v)[0], (*v)[1], (*v)[2], (*v)[3], (*v)[4], (*v)[5]};
  return last_eye_;
}

camera::ImageNoise RemoteView::noise() const {
  const Result<Values> v = look(line_, "noise");
  const std::lock_guard lock(mutex_);
  if (!v || v->size() != 8) return last_noise_;
  const auto half = [&](std::size_t i) {
    return static_cast<std::uint64_t>(whole((*v)[i], kHalf - 1));
  };
  last_noise_ = {{(*v)[0], (*v)[1], (*v)[2], (*v)[3], (*v)[4], (*v)[5]}, half(6) << 32U | half(7)};
  return last_noise_;
}

}  // namespace eyebridge::hal
