#include "eyebridge/localisation/landmark_ekf.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace eyebridge::localisation {
namespace {

constexpr Vec2 kLandmarks[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {2, 1.5}};
constexpr double kForEver = std::numeric_limits<double>::infinity();

Sighting sight(const Pose& pose, Vec2 landmark, const SightingNoise& noise, Random& random) {
  const Vec2 away = landmark - pose.position();
  return {
      norm(away) + noise.range_sigma * random.gaussian(),
      wrap_angle(arc_tan2(away.y, away.x) - pose.theta + noise.bearing_sigma * random.gaussian())};
}

Sighting sight_exactly(const Pose& pose, Vec2 landmark) {
  Random random(1);
  return sight(pose, landmark, {0, 0}, random);
}

/// Wilson and Hilferty's approximation, good to 1e-4 of it from 100 degrees of freedom on.
double chi_square_quantile(double degrees, double normal_quantile) {
  const double spread = 2 / (9 * degrees);
  return degrees * std::pow(1 - spread + normal_quantile * std::sqrt(spread), 3);
}

/// A robot that drives in curves for `kSteps` steps and sees one landmark at each.
constexpr int kSteps = 150;
constexpr int kRuns = 60;
constexpr double kSeconds = 0.2;

Twist twist_at(int step) { return {0.25, 0.6 * std::sin(0.1 * step)}; }

PoseEstimate start() { return {{1, 1, 0.3}, diagonal<3>({0.0025, 0.0025, 0.0025})}; }

Pose scattered(const PoseEstimate& estimate, Random& random) {
  const auto off = [&](std::size_t i) {
    return std::sqrt(estimate.covariance(i, i)) * random.gaussian();
  };
  return {estimate.pose.x + off(0), estimate.pose.y + off(1), estimate.pose.theta + off(2)};
}

/// NEES at each step, the mean of kRuns runs. `move` and `predict` are what happens and what the
/// filter makes of it; the filter believes sightings to err `belief` times as they do.
template <class Move, class Predict>
std::vector<double> mean_errors(Move&& move, Predict&& predict, double belief) {
  const SightingNoise noise{0.03, 0.02};
  const SightingNoise believed{belief * noise.range_sigma, belief * noise.bearing_sigma};
  std::vector<double> means(kSteps, 0.0);
  for (int run = 0; run < kRuns; ++run) {
    Random random(1, static_cast<std::uint64_t>(run));
    LandmarkEkf filter(start());
    Pose truth = scattered(start(), random);
    for (int step = 0; step < kSteps; ++step) {
      truth = move(truth, step, random);
      predict(filter, step);
      const Vec2 landmark = kLandmarks[step % 5];
      filter.update(landmark, sight(truth, landmark, noise, random), believed, kForEver);
      means[static_cast<std::size_t>(step)] +=
          normalised_error_squared(filter.estimate(), truth).value() / kRuns;
    }
  }
  return means;
}

const VelocityNoise kVelocityNoise{0.01, 0.0004, 0.04, 0.01, 0.001, 0.001};

std::vector<double> errors_of_velocities(double belief) {
  return mean_errors(
      [](const Pose& truth, int step, Random& random) {
        return sample_motion(truth, twist_at(step), kSeconds, kVelocityNoise, random);
      },
      [](LandmarkEkf& filter, int step) {
        filter.predict(twist_at(step), kSeconds, kVelocityNoise);
      },
      belief);
}

std::vector<double> errors_of_odometry(double belief) {
  const OdometryNoise noise{0.01, 0.04, 0.01, 0.0004, 0.001, 0.002};
  const auto step_at = [](int step) {
    return OdometryStep{0.05 * std::sin(0.1 * step), 0.05, 0.05 * std::sin(0.1 * step)};
  };
  return mean_errors(
      [&](const Pose& truth, int step, Random& random) {
        return sample_motion(truth, step_at(step), noise, random);
      },
      [&](LandmarkEkf& filter, int step) { filter.predict(step_at(step), noise); }, belief);
}

/// Share of the steps at which the mean of kRuns runs is within its 95 % bounds.
double share_within(const std::vector<double>& means) {
  const double low = chi_square_quantile(3.0 * kRuns, -1.959964) / kRuns;
  const double high = chi_square_quantile(3.0 * kRuns, 1.959964) / kRuns;
  const auto within = std::count_if(means.begin(), means.end(),
                                    [&](double mean) { return mean >= low && mean <= high; });
  return static_cast<double>(within) / static_cast<double>(means.size());
}

TEST(ChiSquareQuantile, AgreesWithTheTables) {
  EXPECT_NEAR(chi_square_quantile(100, 1.959964), 129.561, 0.02);
  EXPECT_NEAR(chi_square_quantile(100, -1.959964), 74.222, 0.02);
}

// Bar-Shalom, Li and Kirubarajan (2001), section 5.4.2. Errors of following steps hang together, so
// that the share scatters more than 150 independent ones would: 5 % outside are meant, 12 % taken.
TEST(LandmarkEkf, IsAsSureAsItMayBeByVelocities) {
  const std::vector<double> means = errors_of_velocities(1.0);
  RecordProperty("steps_within_95_percent_bounds", std::to_string(share_within(means)));
  EXPECT_GE(share_within(means), 0.88);
  EXPECT_LT(share_within(errors_of_velocities(0.7)), 0.3);
  EXPECT_LT(share_within(errors_of_velocities(1.5)), 0.3);
}

TEST(LandmarkEkf, IsAsSureAsItMayBeByOdometry) {
  const std::vector<double> means = errors_of_odometry(1.0);
  RecordProperty("steps_within_95_percent_bounds", std::to_string(share_within(means)));
  EXPECT_GE(share_within(means), 0.88);
  EXPECT_LT(share_within(errors_of_odometry(0.7)), 0.3);
  EXPECT_LT(share_within(errors_of_odometry(1.5)), 0.3);
}

/// Covariance of many samples of a motion, for small noise: that of the filter's prediction.
template <class Sample>
Matrix3 sampled_covariance(const Pose& mean, Sample&& sample) {
  constexpr int kDraws = 40000;
  Random random(9);
  Matrix3 out;
  for (int i = 0; i < kDraws; ++i) {
    const Pose pose = sample(random);
    const Vector3 away{{pose.x - mean.x, pose.y - mean.y, wrap_angle(pose.theta - mean.theta)}};
    out = out + (1.0 / kDraws) * (away * transposed(away));
  }
  return out;
}

void expect_near(const Matrix3& a, const Matrix3& b) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const double scale = std::sqrt(b(row, row) * b(column, column));
      EXPECT_NEAR(a(row, column), b(row, column), 0.03 * scale) << row << ", " << column;
    }
  }
}

TEST(LandmarkEkf, PredictsTheSpreadOfTheMotionModel) {
  const Matrix3 small = diagonal<3>({1e-4, 2e-4, 1e-4});
  const Pose pose{1, 2, 0.7};
  const VelocityNoise slow{1e-3, 1e-4, 1e-3, 1e-3, 1e-3, 1e-3};
  for (const Twist& twist : {Twist{0.5, 0}, Twist{0.5, 1.2}, Twist{-0.3, -0.8}, Twist{0, 1}}) {
    LandmarkEkf filter({pose, small});
    filter.predict(twist, 1.0, slow);
    expect_near(
        sampled_covariance(
            filter.estimate().pose,
            [&](Random& random) {
              return sample_motion(scattered({pose, small}, random), twist, 1.0, slow, random);
            }),
        filter.estimate().covariance);
  }
  const OdometryNoise noise{1e-3, 1e-3, 1e-3, 1e-4, 0.001, 0.001};
  const OdometryStep step{0.4, 0.6, -0.9};
  LandmarkEkf filter({pose, small});
  filter.predict(step, noise);
  expect_near(sampled_covariance(
                  filter.estimate().pose,
                  [&](Random& random) {
                    return sample_motion(scattered({pose, small}, random), step, noise, random);
                  }),
              filter.estimate().covariance);
}

TEST(LandmarkEkf, ComesToWhereExactSightingsSayItIs) {
  const Pose truth{1.3, 1.1, 0.5};
  LandmarkEkf filter({{1.2, 1.2, 0.4}, diagonal<3>({0.04, 0.04, 0.04})});
  for (int round = 0; round < 20; ++round) {
    for (const Vec2 landmark : kLandmarks) {
      filter.update(landmark, sight_exactly(truth, landmark), {0.01, 0.01});
    }
  }
  EXPECT_NEAR(filter.estimate().pose.x, truth.x, 1e-3);
  EXPECT_NEAR(filter.estimate().pose.y, truth.y, 1e-3);
  EXPECT_NEAR(filter.estimate().pose.theta, truth.theta, 1e-3);
  EXPECT_LT(filter.estimate().covariance(0, 0), 1e-5);
}

TEST(LandmarkEkf, LeavesOutASightingThatCannotBe) {
  LandmarkEkf filter(start());
  const PoseEstimate before = filter.estimate();
  // The post at (0, 0), taken for the one at (4, 3).
  const Innovation wrong =
      filter.update({4, 3}, sight_exactly(before.pose, {0, 0}), SightingNoise{});
  EXPECT_FALSE(wrong.accepted);
  EXPECT_GT(wrong.nis, kDefaultGate);
  EXPECT_EQ(filter.estimate().pose, before.pose);
  EXPECT_EQ(filter.estimate().covariance, before.covariance);
  const Innovation on_top = filter.update({1, 1}, {0.1, 0.0}, SightingNoise{}, kForEver);
  EXPECT_FALSE(on_top.accepted);
  EXPECT_TRUE(filter.update({4, 3}, sight_exactly(before.pose, {4, 3}), SightingNoise{}).accepted);
}

TEST(LandmarkEkf, GatesOutOneOfAHundredRightSightings) {
  const SightingNoise noise{0.03, 0.02};
  Random random(12);
  int refused = 0;
  constexpr int kSightings = 20000;
  for (int i = 0; i < kSightings; ++i) {
    LandmarkEkf filter({{1, 1, 0.3}, diagonal<3>({1e-4, 1e-4, 1e-4})});
    const Pose truth = scattered(filter.estimate(), random);
    const Vec2 landmark = kLandmarks[i % 5];
    refused +=
        filter.update(landmark, sight(truth, landmark, noise, random), noise).accepted ? 0 : 1;
  }
  EXPECT_NEAR(static_cast<double>(refused) / kSightings, 0.01, 0.003);
}

TEST(LandmarkEkf, RefusesACovarianceThatIsNoneAndNoiseThatIsNotPositive) {
  EXPECT_THROW(LandmarkEkf({{}, diagonal<3>({1, -1, 1})}), std::invalid_argument);
  EXPECT_THROW(LandmarkEkf({{}, Matrix3{{1, 0.5, 0, 0, 1, 0, 0, 0, 1}}}), std::invalid_argument);
  LandmarkEkf filter(start());
  EXPECT_THROW(filter.update({}, {}, {0.0, 0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::localisation
