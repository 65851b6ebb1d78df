#include "scale/calibration.hpp"

#include <cmath>
#include <memory>
#include <vector>

namespace eyebridge::bench {
namespace {

constexpr double kStepsThere = 76e6;  // a CPU second

class Drive {
 public:
  Drive() = default;
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;
  virtual ~Drive() = default;
  virtual void step(double dt) = 0;
  [[nodiscard]] virtual double x() const = 0;
};

class Differential final : public Drive {
 public:
  explicit Differential(int index) : angular_(0.001 * index), theta_(0.01 * index) {}

  void step(double dt) override {
    const double middle = theta_ + angular_ * dt / 2;
    x_ += 0.3 * dt * std::cos(middle);
    y_ += 0.3 * dt * std::sin(middle);
    theta_ += angular_ * dt;
  }
  [[nodiscard]] double x() const override { return x_ + y_; }

 private:
  double angular_;
  double theta_;
  double x_ = 0.0;
  double y_ = 0.0;
};

}  // namespace

double computer_speed() {
  constexpr int kDrives = 1000;
  constexpr int kRounds = 1000;
  std::vector<std::unique_ptr<Drive>> drives;
  for (int i = 0; i < kDrives; ++i) drives.push_back(std::make_unique<Differential>(i));
  const double start = cpu_seconds();
  for (int round = 0; round < kRounds; ++round) {
    for (const auto& drive : drives) drive->step(0.001);
  }
  const double spent = cpu_seconds() - start;
  // Never true; what nobody reads, nobody computes.
  if (std::isnan(drives.back()->x())) return 0.0;
  return kDrives * kRounds / spent / kStepsThere;
}

}  // namespace eyebridge::bench
