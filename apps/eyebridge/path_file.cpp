#include "path_file.hpp"

#include <chrono>
#include <cstdio>

namespace eyebridge::apps {

PathFile::PathFile(const std::string& path) : file_(open_output(path, kPathOutput)) {}

void PathFile::note(Time now, const robot::Simulation& simulation, std::size_t robots) {
  if (file_ == nullptr || now < due_) return;
  due_ = now + std::chrono::milliseconds(10);
  for (std::size_t i = 0; i < robots; ++i) {
    const Pose pose = simulation.pose(static_cast<robot::RobotIndex>(i));
    std::fprintf(file_.get(), "%.4f,%zu,%.5f,%.5f,%.5f\n", to_seconds(now), i + 1, pose.x, pose.y,
                 pose.theta);
  }
}

}  // namespace eyebridge::apps
