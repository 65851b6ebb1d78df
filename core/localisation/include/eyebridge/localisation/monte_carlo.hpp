#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "eyebridge/localisation/likelihood_field.hpp"
#include "eyebridge/localisation/motion_model.hpp"
#include "eyebridge/localisation/pose_estimate.hpp"
#include "eyebridge/localisation/scan.hpp"

namespace eyebridge::localisation {

/// Settings of a MonteCarlo.
struct MonteCarloSettings {
  std::size_t least_particles = 500;   ///< > 0.
  std::size_t most_particles = 20000;  ///< >= least; as many as a start anywhere spreads.
  OdometryNoise motion;
  /// Exponent of a scan's likelihood, > 0, at most 1: beams beside each other err together, which
  /// their product does not know (Probabilistic Robotics, section 6.3.4).
  double beam_exponent = 0.2;
  double resample_below = 0.5;  ///< Share of effective particles, 0 … 1, under which it resamples.
  /// Rates of the long and the short mean of how well scans fit, 0 <= slow < fast <= 1; with slow 0
  /// no particle is ever put elsewhere (Probabilistic Robotics, section 8.3.3).
  double slow_rate = 0.02;
  double fast_rate = 0.3;
  double bin_size = 0.2;         ///< Of KLD-sampling and clusters, metres, > 0.
  double bin_turn = 0.26179938;  ///< Likewise, radians, > 0.
  /// KLD-sampling: the particles' distribution is nearer to the belief than this, > 0, with the
  /// probability of which `kld_quantile` is the normal quantile.
  double kld_error = 0.05;
  double kld_quantile = 2.326;
};

/// The heaviest cluster of particles.
struct Cluster {
  PoseEstimate estimate;  ///< Weighted mean, of headings as directions, and covariance.
  double share = 0.0;     ///< Of the whole belief, 0 … 1.
  std::size_t particles = 0;
};

/// Monte-Carlo localisation on a known map: where a robot is, from nothing but its odometry and its
/// scans.
///
/// Augmented MCL of S. Thrun, W. Burgard and D. Fox, "Probabilistic Robotics" (2005), table 8.3,
/// with low-variance resampling (table 4.4) when few particles are effective (A. Doucet, 1998), and
/// as many particles as the belief is wide: KLD-sampling, D. Fox, "Adapting the Sample Size in
/// Particle Filters Through KLD-Sampling", IJRR 22 (2003) 985. Same calls, same seed, same bits.
/// Not thread-safe.
class MonteCarlo {
 public:
  /// On the map `field`; robots are only ever where `free` is not 0. Throws std::invalid_argument
  /// for settings out of range, without a field, and when nothing is free.
  MonteCarlo(std::shared_ptr<const LikelihoodField> field,
             const mapping::Raster<std::uint8_t>& free, const MonteCarloSettings& settings,
             std::uint64_t seed);

  /// Forgets everything: the robot may be anywhere that is free, with any heading.
  void start_anywhere();
  /// Forgets everything: the robot is at `pose`, give or take the deviations (metres, radians).
  /// Throws std::invalid_argument unless all are finite and the deviations not negative.
  void start_at(const Pose& pose, double position_sigma, double heading_sigma);

  /// The robot moved, as its odometry says, from `before` to `after`.
  void predict(const Pose& before, const Pose& after);
  /// The robot sees `scan`; the time is that of its hits: Scan::thinned() to some 60. Resamples
  /// when too few particles are effective, or when scans have fitted badly of late. A scan without
  /// hits changes nothing.
  void correct(const Scan& scan);

  /// Of the particles, in bins that touch, that have most of the belief.
  [[nodiscard]] Cluster estimate() const;
  [[nodiscard]] const Particles& particles() const { return particles_; }
  /// 1 / sum of the squares of the weights: 1 … as many as there are.
  [[nodiscard]] double effective_particles() const;
  /// Share of particles that the next resampling puts anywhere, 0 … 1.
  [[nodiscard]] double lost_share() const;
  [[nodiscard]] const MonteCarloSettings& settings() const { return settings_; }

 private:
  void weigh(const Scan& scan);
  void resample();
  [[nodiscard]] Pose any_pose();

  std::shared_ptr<const LikelihoodField> field_;
  mapping::GridGeometry free_geometry_;
  std::vector<mapping::Cell> free_;
  MonteCarloSettings settings_;
  Random random_;
  Particles particles_;
  Particles drawn_;  ///< Room for resampling.
  std::vector<double> log_likelihood_;
  std::vector<std::size_t> chosen_;
  std::optional<double> slow_fit_;  ///< Long mean of a beam's likelihood.
  double fast_fit_ = 0.0;
};

}  // namespace eyebridge::localisation
