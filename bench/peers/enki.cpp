// Enki (libenki-dev, as Debian has it) at the work of bench/scale: enki SENSE ROBOTS STEP SECONDS
// DATA. Prints one line, as every program of `./test peers` does; see README.md.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <enki/PhysicalEngine.h>
#include <enki/interactions/CircularCam.h>
#include <enki/interactions/IRSensor.h>
#include <enki/robots/DifferentialWheeled.h>
#include <time.h>

#include "scale/wander.hpp"

namespace {

using eyebridge::Twist;
using eyebridge::bench::Wander;

constexpr double kTick = 0.1;       // seconds between two decisions
constexpr double kCm = 100.0;       // a metre; Enki's lengths are centimetres
constexpr double kWheelBase = 9.0;  // cm
constexpr double kHeight = 10.0;    // cm, of walls and robots; sensors are half as high
constexpr double kPsdReach = 4.0, kLidarReach = 8.0;  // metres
constexpr std::size_t kPsds = 8, kCameras = 4, kPixels = 90;

std::vector<std::vector<double>> read_table(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<double>& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
  }
  return rows;
}

/// A disc of 0.2 m. Its sensors cost what they cost in Enki: each infrared one casts three rays.
class Robot : public Enki::DifferentialWheeled {
 public:
  Robot(const std::string& sense, unsigned number)
      : DifferentialWheeled(kWheelBase, 1000.0, 0.0), wander_(number) {
    setCylindric(0.1 * kCm, kHeight, 100.0);
    if (sense == "psd") {
      for (std::size_t i = 0; i < kPsds; ++i) {  // clockwise from behind
        const double bearing =
            std::numbers::pi - 2 * std::numbers::pi / kPsds * static_cast<double>(i);
        psds_.push_back(new Enki::IRSensor(this, {0.0, 0.0}, kHeight / 2, bearing, kPsdReach * kCm,
                                           3600.0, 0.0, 20.0));
        addLocalInteraction(psds_.back());
      }
      ranges_.resize(kPsds);
    } else if (sense == "lidar") {
      for (std::size_t i = 0; i < kCameras;
           ++i) {  // clockwise, the first one looks to the left rear
        const double bearing = std::numbers::pi * (0.75 - 0.5 * static_cast<double>(i));
        cameras_.push_back(new Enki::CircularCam(this, {0.0, 0.0}, kHeight / 2, bearing,
                                                 std::numbers::pi / 4, kPixels));
        cameras_.back()->setRange(kLidarReach * kCm);
        addLocalInteraction(cameras_.back());
      }
      ranges_.resize(kCameras * kPixels);
    }
  }
  ~Robot() override {
    for (Enki::IRSensor* psd : psds_) delete psd;
    for (Enki::CircularCam* camera : cameras_) delete camera;
  }

  void decide() {
    const Twist twist = ranges_.empty() ? wander_.blind() : wander_.steer(look());
    const double turn = twist.angular * kWheelBase / 2;
    leftSpeed = twist.linear * kCm - turn;
    rightSpeed = twist.linear * kCm + turn;
  }

  double range_sum = 0.0;
  double hits = 0.0;
  double rays = 0.0;

 private:
  const std::vector<double>& look() {
    double reach = kPsdReach;
    for (std::size_t i = 0; i < psds_.size(); ++i) ranges_[i] = psds_[i]->getRayDist(1) / kCm;
    if (!cameras_.empty()) {
      reach = kLidarReach;
      for (std::size_t i = 0; i < ranges_.size(); ++i) {  // a camera's pixels go from right to left
        const double squared = cameras_[i / kPixels]->zbuffer[kPixels - 1 - i % kPixels];
        ranges_[i] = std::sqrt(squared) / kCm;
      }
    }
    for (double& range : ranges_) {
      range = std::min(range, reach);
      range_sum += range;
      hits += range < 0.999 * reach ? 1.0 : 0.0;
    }
    rays += static_cast<double>(ranges_.size());
    return ranges_;
  }

  Wander wander_;
  std::vector<Enki::IRSensor*> psds_;
  std::vector<Enki::CircularCam*> cameras_;
  std::vector<double> ranges_;
};

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void run(const std::string& sense, std::size_t robots, double step, double seconds,
         const std::string& data) {
  Enki::World world;
  for (const auto& wall : read_table(data + "/walls.csv")) {
    auto* box = new Enki::PhysicalObject;
    box->setRectangular(wall[2] * kCm, wall[3] * kCm, kHeight, -1.0);
    box->pos = {wall[0] * kCm, wall[1] * kCm};
    box->angle = wall[4];
    world.addObject(box);
  }
  const auto starts = read_table(data + "/robots.csv");
  std::vector<Robot*> all;
  for (std::size_t i = 0; i < robots; ++i) {
    all.push_back(new Robot(sense, static_cast<unsigned>(i)));
    all.back()->pos = {starts.at(i)[0] * kCm, starts[i][1] * kCm};
    all.back()->angle = starts[i][2];
    world.addObject(all.back());
  }
  const auto oversampling = static_cast<unsigned>(std::lround(kTick / step));
  const auto ticks = static_cast<long>(std::lround(seconds / kTick));
  world.step(1e-9);  // sensors read where the robots begin
  double distance = 0.0;
  std::vector<Enki::Point> before;
  const double start = cpu_seconds();
  for (long tick = 0; tick < ticks; ++tick) {
    for (Robot* robot : all) robot->decide();
    before.clear();
    for (Robot* robot : all) before.push_back(robot->pos);
    world.step(kTick, oversampling);
    for (std::size_t i = 0; i < all.size(); ++i) distance += (all[i]->pos - before[i]).norm() / kCm;
  }
  const double spent = cpu_seconds() - start;
  double sum = 0.0;
  double hits = 0.0;
  double rays = 0.0;
  for (const Robot* robot : all) {
    sum += robot->range_sum;
    hits += robot->hits;
    rays += robot->rays;
  }
  rays = std::max(rays, 1.0);
  std::printf("cpu_s=%.6f distance_m=%.4f range_m=%.4f hits=%.4f\n", spent,
              distance / static_cast<double>(robots), sum / rays, hits / rays);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::fprintf(stderr, "usage: enki psd|lidar|none ROBOTS STEP_S SECONDS DATA\n");
    return 2;
  }
  try {
    run(argv[1], std::stoul(argv[2]), std::stod(argv[3]), std::stod(argv[4]), argv[5]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "enki: %s\n", error.what());
    return 1;
  }
}
