#include <benchmark/benchmark.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/pose_finder.hpp"
#include "fiducials/vision.hpp"
#include "lens_effects.hpp"
#include "optics/undistortion.hpp"
#include "vision/aruco.hpp"

// CPU time a VGA frame of finding a camera's pose, and of straightening a picture; the baselines
// are OpenCV's own detector as it comes, and its remap with fixed-point maps, on the same frames.

namespace eyebridge::camera {
namespace {

struct Room {
  world::WorldModel model;
  std::vector<Fiducial> fiducials;
  Calibration lens = pinhole({640, 480}, deg_to_rad(60.0));

  Room() {
    model.width = model.height = 1.0;
    model.walls = {{{1.0, 0.0}, {1.0, 1.0}}, {{0.0, 1.0}, {1.0, 1.0}}};
    fiducials = place_fiducials(model);
  }

  /// Five fiducials in view, blurred, in normal light or dim.
  [[nodiscard]] Frame picture(double light) const {
    const testing::WallPainter painter(model, fiducials);
    const EyePose eye{{0.2, 0.2, 0.12, 0.75, 0.0, 0.0}};
    Random random(3);
    return testing::LensCamera(painter, lens).take(eye, eye, {.light = light}, random);
  }
};

void find_pose(benchmark::State& state) {
  const Room room;
  NullLog log;
  const auto finder = make_fiducial_finder(room.fiducials, room.lens, log);
  Frame frame = room.picture(static_cast<double>(state.range(0)) / 100.0);
  int found = 0;
  for (auto _ : state) {
    frame.time += Time(33'333'333);
    const auto pose = finder->take(frame);
    found = pose ? pose->fiducials : 0;
  }
  state.counters["fiducials"] = found;
}
BENCHMARK(find_pose)->Arg(100)->Arg(30)->Unit(benchmark::kMillisecond);

void opencv_detector_as_it_comes(benchmark::State& state) {
  cv::setNumThreads(1);
  Frame frame = Room().picture(static_cast<double>(state.range(0)) / 100.0);
  const cv::Mat grey(frame.height, frame.width, CV_8U, frame.bytes.data());
  cv::aruco::DetectorParameters parameters;
  parameters.cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  std::size_t found = 0;
  for (auto _ : state) found = find_squares(grey, parameters, FiducialFamily::Aruco5x5).ids.size();
  state.counters["fiducials"] = static_cast<double>(found);
}
BENCHMARK(opencv_detector_as_it_comes)->Arg(100)->Arg(30)->Unit(benchmark::kMillisecond);

Calibration bent() {
  Calibration lens = pinhole({640, 480}, deg_to_rad(60.0));
  lens.distortion = {-0.28, 0.07, 0.0008, -0.0012, 0.0};
  return lens;
}

void undistort_rgb(benchmark::State& state) {
  const Frame frame = to_rgb24(Room().picture(1.0));
  const Undistortion undistortion(bent());
  for (auto _ : state) benchmark::DoNotOptimize(undistortion.apply(frame));
}
BENCHMARK(undistort_rgb)->Unit(benchmark::kMillisecond);

void opencv_remap_rgb(benchmark::State& state) {
  cv::setNumThreads(1);
  Frame frame = to_rgb24(Room().picture(1.0));
  const cv::Mat picture(frame.height, frame.width, CV_8UC3, frame.bytes.data());
  const Calibration lens = bent();
  const cv::Matx33d camera(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1);
  cv::Mat first;
  cv::Mat second;
  cv::initUndistortRectifyMap(camera, lens.distortion, cv::noArray(), camera, picture.size(),
                              CV_16SC2, first, second);
  for (auto _ : state) {
    cv::Mat out;
    cv::remap(picture, out, first, second, cv::INTER_LINEAR);
    benchmark::DoNotOptimize(out.data);
  }
}
BENCHMARK(opencv_remap_rgb)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace eyebridge::camera
