#include "eyebridge/localisation/monte_carlo.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "eyebridge/localisation/resampling.hpp"
#include "pose_bins.hpp"

namespace eyebridge::localisation {
namespace {

void check_settings(const MonteCarloSettings& s) {
  const bool good = s.least_particles > 0 && s.most_particles >= s.least_particles &&
                    s.beam_exponent > 0.0 && s.beam_exponent <= 1.0 && s.resample_below >= 0.0 &&
                    s.resample_below <= 1.0 && s.slow_rate >= 0.0 && s.slow_rate < s.fast_rate &&
                    s.fast_rate <= 1.0 && s.bin_size > 0.0 && s.bin_turn > 0.0 && s.kld_error > 0.0;
  if (!good) throw std::invalid_argument("Monte-Carlo localisation: settings out of range");
}

std::vector<mapping::Cell> cells_set(const mapping::Raster<std::uint8_t>& raster) {
  std::vector<mapping::Cell> out;
  for (int row = 0; row < raster.geometry.rows; ++row) {
    for (int column = 0; column < raster.geometry.columns; ++column) {
      if (raster[{column, row}] != 0) out.push_back({column, row});
    }
  }
  return out;
}

/// Weighted mean and covariance of the particles of one cluster.
PoseEstimate moments_of_cluster(const Particles& particles,
                                const std::vector<std::uint32_t>& clusters, std::uint32_t cluster,
                                double share) {
  Vec2 place;
  Vec2 direction;
  const auto for_each = [&](auto&& visit) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
      if (clusters[i] == cluster) visit(particles.pose(i), particles.weight[i] / share);
    }
  };
  for_each([&](const Pose& pose, double weight) {
    place = place + weight * pose.position();
    direction = direction + weight * Heading::from_angle(pose.theta).forward();
  });
  PoseEstimate out;
  out.pose = {place.x, place.y, arc_tan2(direction.y, direction.x)};
  for_each([&](const Pose& pose, double weight) {
    const Vector3 away{
        {pose.x - out.pose.x, pose.y - out.pose.y, wrap_angle(pose.theta - out.pose.theta)}};
    out.covariance = out.covariance + weight * (away * transposed(away));
  });
  return out;
}

}  // namespace

MonteCarlo::MonteCarlo(std::shared_ptr<const LikelihoodField> field,
                       const mapping::Raster<std::uint8_t>& free,
                       const MonteCarloSettings& settings, std::uint64_t seed)
    : field_(std::move(field)),
      free_geometry_(free.geometry),
      free_(cells_set(free)),
      settings_(settings),
      random_(seed) {
  check_settings(settings_);
  if (field_ == nullptr) throw std::invalid_argument("Monte-Carlo localisation: expected a field");
  if (free_.empty()) throw std::invalid_argument("Monte-Carlo localisation: nothing is free");
  start_anywhere();
}

Pose MonteCarlo::any_pose() {
  const auto choice =
      static_cast<std::size_t>(random_.uniform() * static_cast<double>(free_.size()));
  const Vec2 centre = free_geometry_.centre_of(free_[choice]);
  const double x = centre.x + (random_.uniform() - 0.5) * free_geometry_.resolution;
  const double y = centre.y + (random_.uniform() - 0.5) * free_geometry_.resolution;
  return {x, y, wrap_angle(2 * kPi * random_.uniform())};
}

void MonteCarlo::start_anywhere() {
  particles_.clear();
  const std::size_t count = settings_.most_particles;
  for (std::size_t i = 0; i < count; ++i) {
    particles_.add(any_pose(), 1.0 / static_cast<double>(count));
  }
  slow_fit_.reset();
}

void MonteCarlo::start_at(const Pose& pose, double position_sigma, double heading_sigma) {
  const bool good = std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.theta) &&
                    position_sigma >= 0.0 && std::isfinite(position_sigma) &&
                    heading_sigma >= 0.0 && std::isfinite(heading_sigma);
  if (!good) throw std::invalid_argument("Monte-Carlo localisation: a start that cannot be");
  particles_.clear();
  const std::size_t count = settings_.least_particles;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = pose.x + position_sigma * random_.gaussian();
    const double y = pose.y + position_sigma * random_.gaussian();
    const double theta = wrap_angle(pose.theta + heading_sigma * random_.gaussian());
    particles_.add({x, y, theta}, 1.0 / static_cast<double>(count));
  }
  slow_fit_.reset();
}

void MonteCarlo::predict(const Pose& before, const Pose& after) {
  if (before == after) return;
  sample_motion(particles_, OdometryStep::between(before, after), settings_.motion, random_);
}

void MonteCarlo::weigh(const Scan& scan) {
  log_likelihood_.resize(particles_.size());
  field_->log_likelihoods(particles_, scan.hits, log_likelihood_);
  const double highest = *std::max_element(log_likelihood_.begin(), log_likelihood_.end());
  // Recovery goes by the geometric mean of a scan's beams: their product would say more about how
  // many there were than about how well they fit.
  const double beams = static_cast<double>(scan.hits.size());
  double fit = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    double& weight = particles_.weight[i];
    fit += weight * exp_of(log_likelihood_[i] / beams - field_->highest());
    weight *= exp_of(settings_.beam_exponent * (log_likelihood_[i] - highest));
    total += weight;
  }
  // The likeliest one may have had no weight left: then all count by this scan alone.
  if (!(total > 0.0)) {
    total = 0.0;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      particles_.weight[i] = exp_of(settings_.beam_exponent * (log_likelihood_[i] - highest));
      total += particles_.weight[i];
    }
  }
  for (double& weight : particles_.weight) weight /= total;
  if (!slow_fit_) {
    slow_fit_ = fit;
    fast_fit_ = fit;
  } else {
    *slow_fit_ += settings_.slow_rate * (fit - *slow_fit_);
    fast_fit_ += settings_.fast_rate * (fit - fast_fit_);
  }
}

double MonteCarlo::effective_particles() const {
  double squares = 0.0;
  for (const double weight : particles_.weight) squares += weight * weight;
  return 1.0 / squares;
}

double MonteCarlo::lost_share() const {
  if (settings_.slow_rate == 0.0 || !slow_fit_ || !(*slow_fit_ > 0.0)) return 0.0;
  return std::clamp(1.0 - fast_fit_ / *slow_fit_, 0.0, 1.0);
}

void MonteCarlo::resample() {
  const double lost = lost_share();
  const auto now = static_cast<double>(particles_.size());
  low_variance_sample(particles_.weight, particles_.size(), random_.uniform(), chosen_);
  // What is put anywhere falls into a bin of its own.
  const PoseBins bins(settings_.bin_size, settings_.bin_turn);
  const auto elsewhere = static_cast<std::size_t>(lost * now);
  const double wanted = kld_sample_size(bins.count(particles_, chosen_) + elsewhere,
                                        settings_.kld_error, settings_.kld_quantile);
  const double count = std::clamp(wanted, static_cast<double>(settings_.least_particles),
                                  static_cast<double>(settings_.most_particles));
  const double lost_count = std::floor(lost * count);
  const auto total = static_cast<std::size_t>(count);
  const std::size_t kept = total - static_cast<std::size_t>(lost_count);
  low_variance_sample(particles_.weight, kept, random_.uniform(), chosen_);
  drawn_.clear();
  drawn_.reserve(total);
  const double share = 1.0 / static_cast<double>(total);
  for (const std::size_t i : chosen_) drawn_.add(particles_.pose(i), share);
  while (drawn_.size() < total) drawn_.add(any_pose(), share);
  std::swap(particles_, drawn_);
}

void MonteCarlo::correct(const Scan& scan) {
  if (scan.hits.empty()) return;
  weigh(scan);
  const double enough = settings_.resample_below * static_cast<double>(particles_.size());
  if (effective_particles() < enough || lost_share() > 0.0) resample();
}

Cluster MonteCarlo::estimate() const {
  const PoseBins bins(settings_.bin_size, settings_.bin_turn);
  const std::vector<std::uint32_t> clusters = bins.clusters(particles_);
  const std::size_t count = *std::max_element(clusters.begin(), clusters.end()) + std::size_t{1};
  std::vector<double> shares(count, 0.0);
  for (std::size_t i = 0; i < clusters.size(); ++i) shares[clusters[i]] += particles_.weight[i];
  const auto best = std::max_element(shares.begin(), shares.end());
  const auto cluster = static_cast<std::uint32_t>(best - shares.begin());
  Cluster out;
  out.share = std::min(*best, 1.0);
  out.particles = static_cast<std::size_t>(std::count(clusters.begin(), clusters.end(), cluster));
  out.estimate = moments_of_cluster(particles_, clusters, cluster, *best);
  return out;
}

}  // namespace eyebridge::localisation
