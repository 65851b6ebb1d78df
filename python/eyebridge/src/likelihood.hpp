#pragma once

#include <optional>
#include <stdexcept>

#include <pybind11/numpy.h>

#include "arrays.hpp"
#include "checks.hpp"
#include "eyebridge/robot/sensor_likelihood.hpp"

namespace eyebridge::python {

/// P(reading | truth) for arrays of both; `readings_of(truth)` gives the distribution of the
/// readings there. Raises ValueError for a resolution that is not above 0.
template <class ReadingsOf>
pybind11::object probabilities(const Numbers& readings, const Numbers& truths, double resolution,
                               ReadingsOf&& readings_of) {
  if (!(resolution > 0.0)) refuse("resolution", resolution, "more than 0");
  return pybind11::vectorize([&](double reading, double truth) {
    return readings_of(truth).probability(reading, resolution);
  })(readings, truths);
}

/// The same of answers that are yes or no: numbers other than 0 are yes.
template <class Error>
pybind11::object probabilities_of_switch(const Error& error, const Numbers& readings,
                                         const Numbers& truths) {
  return pybind11::vectorize([&](double reading, double truth) {
    return robot::probability(error, reading != 0.0, truth != 0.0);
  })(readings, truths);
}

inline pybind11::object lidar_probabilities(const robot::RobotModel& model, const Numbers& readings,
                                            const Numbers& distances, double resolution) {
  const std::optional<robot::LidarModel>& lidar = model.lidar;
  if (!lidar) throw std::invalid_argument("this robot has no lidar");
  return probabilities(readings, distances, resolution,
                       [&](double truth) { return robot::RangeReadings(*lidar, truth); });
}

inline pybind11::object compass_probabilities(const robot::RobotModel& model,
                                              const Numbers& readings, const Numbers& headings,
                                              double resolution) {
  return probabilities(readings, headings, resolution, [&](double truth) {
    return robot::HeadingReadings(model.compass_error, truth);
  });
}

inline pybind11::object gyroscope_probabilities(const robot::RobotModel& model,
                                                const Numbers& readings, const Numbers& rates,
                                                double resolution, double elapsed) {
  if (!(elapsed >= 0.0)) refuse("elapsed", elapsed, "0 or more");
  return probabilities(readings, rates, resolution, [&](double truth) {
    return robot::NormalReadings(model.gyroscope_error, truth, elapsed);
  });
}

inline pybind11::object accelerometer_probabilities(const robot::RobotModel& model,
                                                    const Numbers& readings,
                                                    const Numbers& accelerations,
                                                    double resolution) {
  return probabilities(readings, accelerations, resolution, [&](double truth) {
    return robot::NormalReadings(model.accelerometer_error, truth);
  });
}

/// `readings` in ticks, `angles` in radians.
inline pybind11::object encoder_probabilities(const robot::RobotModel& model,
                                              const Numbers& readings, const Numbers& angles,
                                              double resolution) {
  return probabilities(readings, angles, resolution, [&](double truth) {
    return robot::TickReadings(model.drive_error, model.drive.ticks_per_revolution, truth);
  });
}

}  // namespace eyebridge::python
