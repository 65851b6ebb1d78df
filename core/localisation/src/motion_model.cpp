#include "eyebridge/localisation/motion_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "eyebridge/robot/arc.hpp"

namespace eyebridge::localisation {
namespace {

constexpr double kNoTravel = 1e-4;  // metres

double square_of(double value) { return value * value; }

StepVariances roots_of(const StepVariances& v) {
  return {std::sqrt(v.first_turn), std::sqrt(v.travel), std::sqrt(v.second_turn)};
}

Pose drawn(const Pose& pose, const OdometryStep& step, const StepVariances& sigmas,
           Random& random) {
  OdometryStep real;
  real.first_turn = step.first_turn + sigmas.first_turn * random.gaussian();
  real.travel = step.travel + sigmas.travel * random.gaussian();
  real.second_turn = step.second_turn + sigmas.second_turn * random.gaussian();
  return real.applied_to(pose);
}

/// What a drive's errors come to over one step of a filter.
struct DriveVariances {
  double travel_by_travel;
  double travel_by_turn;
  double turn_by_travel;  ///< In all, rad^2 / m^2.
  double turn_by_turn;
  double least_travel_sigma;
  double least_turn_sigma;
};

DriveVariances drive_variances(const robot::DriveError& error, const robot::DriveModel& drive,
                               double travel, double tick) {
  if (!(travel > 0.0 && tick > 0.0 && drive.wheel_base > 0.0 && drive.ticks_per_revolution > 0.0)) {
    throw std::invalid_argument("motion noise: lengths and ticks must be positive");
  }
  const double steps = std::max(1.0, travel / tick);
  const double mean_scale = (error.left_scale + error.right_scale) / 2;
  const double turn_scale = (error.right_scale - error.left_scale) / drive.wheel_base;
  // Of one wheel, each step: all of its travel with probability `slip`, else none.
  const double slips = error.slip * (1.0 - error.slip) / steps;
  const double quantum = kPi * drive.wheel_diameter / drive.ticks_per_revolution;
  // Whole ticks at both ends of the step, for each wheel: the difference of two even spreads.
  const double rounding = error.counts_ticks() ? square_of(quantum) / 6 : 0.0;
  const double missed = error.encoder_miss;
  DriveVariances out{};
  out.travel_by_travel = square_of(error.linear_sigma) / steps +
                         square_of(mean_scale - error.slip + missed) + slips / 2;
  out.turn_by_travel = square_of(turn_scale) + 2 * slips / square_of(drive.wheel_base);
  out.turn_by_turn = square_of(error.angular_sigma) / steps +
                     square_of(mean_scale - error.slip + missed) + slips / 2;
  // A turn drives the wheels half a wheel base each: what they differ by moves the centre.
  const double half_base = drive.wheel_base / 2;
  out.travel_by_turn = square_of(half_base) * (square_of(turn_scale * half_base) + slips / 2);
  out.least_travel_sigma = std::sqrt(rounding / 2);
  out.least_turn_sigma = std::sqrt(2 * rounding) / drive.wheel_base;
  return out;
}

}  // namespace

void Particles::clear() {
  x.clear();
  y.clear();
  theta.clear();
  weight.clear();
}

void Particles::reserve(std::size_t count) {
  x.reserve(count);
  y.reserve(count);
  theta.reserve(count);
  weight.reserve(count);
}

void Particles::add(const Pose& pose, double share) {
  x.push_back(pose.x);
  y.push_back(pose.y);
  theta.push_back(pose.theta);
  weight.push_back(share);
}

OdometryStep OdometryStep::between(const Pose& before, const Pose& after) {
  const Pose local = relative_to(before, after);
  const double travel = norm(local.position());
  // Too short to have a direction, but many such steps are a way.
  if (travel < kNoTravel) return {0.0, local.x, local.theta};
  const double bearing = arc_tan2(local.y, local.x);
  if (std::abs(bearing) <= kPi / 2) return {bearing, travel, wrap_angle(local.theta - bearing)};
  // Backwards: not a turn by pi, which the robot did not make, with its error.
  const double back = wrap_angle(bearing + kPi);
  return {back, -travel, wrap_angle(local.theta - back)};
}

Pose OdometryStep::applied_to(const Pose& pose) const {
  const double course = pose.theta + first_turn;
  const Vec2 place = pose.position() + travel * Heading::from_angle(course).forward();
  return {place.x, place.y, wrap_angle(course + second_turn)};
}

StepVariances variances_of(const OdometryStep& step, const OdometryNoise& noise) {
  const double travel = square_of(step.travel);
  const double first = square_of(step.first_turn);
  const double second = square_of(step.second_turn);
  const double turn_floor = square_of(noise.least_turn_sigma);
  return {
      noise.turn_by_turn * first + noise.turn_by_travel * travel + turn_floor,
      noise.travel_by_travel * travel + noise.travel_by_turn * (first + second) +
          square_of(noise.least_travel_sigma),
      noise.turn_by_turn * second + noise.turn_by_travel * travel + turn_floor,
  };
}

OdometryNoise odometry_noise(const robot::DriveError& error, const robot::DriveModel& drive,
                             double travel, double tick) {
  const DriveVariances v = drive_variances(error, drive, travel, tick);
  OdometryNoise noise;
  noise.turn_by_turn = v.turn_by_turn;
  noise.turn_by_travel = v.turn_by_travel / 2;  // shared by the two turns
  noise.travel_by_travel = v.travel_by_travel;
  noise.travel_by_turn = v.travel_by_turn;
  noise.least_travel_sigma = v.least_travel_sigma;
  noise.least_turn_sigma = v.least_turn_sigma / std::sqrt(2.0);
  return noise;
}

Pose sample_motion(const Pose& pose, const OdometryStep& step, const OdometryNoise& noise,
                   Random& random) {
  return drawn(pose, step, roots_of(variances_of(step, noise)), random);
}

void sample_motion(Particles& particles, const OdometryStep& step, const OdometryNoise& noise,
                   Random& random) {
  const StepVariances sigmas = roots_of(variances_of(step, noise));
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Pose pose = drawn(particles.pose(i), step, sigmas, random);
    particles.x[i] = pose.x;
    particles.y[i] = pose.y;
    particles.theta[i] = pose.theta;
  }
}

double VelocityNoise::linear_variance(const Twist& twist) const {
  return linear_by_linear * square_of(twist.linear) + linear_by_angular * square_of(twist.angular);
}

double VelocityNoise::angular_variance(const Twist& twist) const {
  return angular_by_linear * square_of(twist.linear) +
         angular_by_angular * square_of(twist.angular);
}

double VelocityNoise::spin_variance(const Twist& twist) const {
  return spin_by_linear * square_of(twist.linear) + spin_by_angular * square_of(twist.angular);
}

VelocityNoise velocity_noise(const robot::DriveError& error, const robot::DriveModel& drive,
                             double travel, double tick) {
  const DriveVariances v = drive_variances(error, drive, travel, tick);
  return {v.travel_by_travel, v.travel_by_turn, v.turn_by_travel, v.turn_by_turn, 0.0, 0.0};
}

Pose sample_motion(const Pose& pose, const Twist& twist, double seconds, const VelocityNoise& noise,
                   Random& random) {
  const double linear = twist.linear + std::sqrt(noise.linear_variance(twist)) * random.gaussian();
  const double angular =
      twist.angular + std::sqrt(noise.angular_variance(twist)) * random.gaussian();
  const double spin = std::sqrt(noise.spin_variance(twist)) * random.gaussian();
  const world::Arc arc = robot::arc_of({linear * seconds, angular * seconds});
  const Vec2 place = pose.position() + Heading::from_angle(pose.theta).rotate(arc.displacement);
  return {place.x, place.y, wrap_angle(pose.theta + (angular + spin) * seconds)};
}

}  // namespace eyebridge::localisation
