#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/localisation/motion_model.hpp"

namespace eyebridge::localisation {

/// Poses sorted into bins of equal size over place and heading.
class PoseBins {
 public:
  /// Of a bin, metres and radians, both > 0.
  PoseBins(double size, double turn);

  /// A number for the bin of `pose`: the same number, the same bin.
  [[nodiscard]] std::uint64_t key_of(const Pose& pose) const;
  /// How many bins the chosen ones of `particles` are in.
  [[nodiscard]] std::size_t count(const Particles& particles,
                                  std::span<const std::size_t> chosen) const;
  /// For each particle the number of its cluster: particles in bins that touch, be it at corners,
  /// are in one. Numbers begin with 0.
  [[nodiscard]] std::vector<std::uint32_t> clusters(const Particles& particles) const;

 private:
  /// Place of the bin, within a cube of 2^21 bins to each side.
  struct Place {
    std::int64_t x;
    std::int64_t y;
    std::int64_t turn;
  };
  [[nodiscard]] static std::uint64_t key_of(const Place& place);
  [[nodiscard]] static Place place_of(std::uint64_t key);

  double size_;
  std::int64_t turns_;  ///< Bins of a whole turn.
};

}  // namespace eyebridge::localisation
