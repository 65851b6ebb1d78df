#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "beam_table.hpp"
#include "beam_walk.hpp"
#include "eyebridge/base/pose.hpp"
#include "scan_notes.hpp"

// Before a loop: its arrays are different ones.
#if defined(__GNUC__) && !defined(__clang__)
#define EYEBRIDGE_DIFFERENT_ARRAYS _Pragma("GCC ivdep")
#else
#define EYEBRIDGE_DIFFERENT_ARRAYS
#endif

namespace eyebridge::mapping {

struct RayExtent {
  bool empty = true;  ///< No beam says anything.
  Vec2 lower;
  Vec2 upper;
};

/// What all beams of scans have in common.
struct RayModel {
  double max_range = 0.0;     ///< Metres.
  double out_of_range = 0.0;  ///< Metres.
  double bias = 0.0;          ///< Metres.
  double per_metre = 0.0;     ///< Cells.
  double close = 0.0;  ///< As far as the next beams lie close to each other; 0: nothing is filled.
  bool fills_unmet = false;  ///< Whether it is filled, too, what beams cross that meet nothing.
};

/// Where a scan is drawn.
struct RayFrame {
  Box box;
  Vec2 origin;              ///< Of the beams, in cells of the box.
  std::int64_t column = 0;  ///< Of the sensor's own cell.
  std::int64_t row = 0;
  bool clipped = false;  ///< Whether beams may leave the box.
};

/// The beams of a scan, an array for each of their properties: compilers make several at once of
/// loops over them. Lengths are in cells, places from the sensor, but where it says metres.
struct ScanRays {
  /// What a reading is good for.
  enum Kind : std::int32_t { kSilent, kUnmet, kMet };

  std::size_t count = 0;
  std::vector<float> x;  ///< Directions.
  std::vector<float> y;
  std::vector<std::int32_t> kind;
  // Of those that met something; for others any numbers.
  std::vector<float> sigma;
  std::vector<std::int32_t> level;  ///< Of the table's blurs.
  std::vector<float> place;         ///< Where that was.
  std::vector<float> reach;         ///< Of what is said around that.
  // Of all.
  std::vector<float> clear;     ///< How far the cells are filled.
  std::vector<float> own_from;  ///< From where on a beam says itself what it crosses.
  std::vector<float> corner_x;  ///< Of what is filled.
  std::vector<float> corner_y;
  std::vector<float> tip_x;  ///< Beyond the last cell that it speaks of.
  std::vector<float> tip_y;
  RayExtent extent;  ///< Of the tips, with the sensor.

  /// Takes a scan, as many directions as ranges; false where a direction is no unit vector.
  bool set(const BeamTable& table, const RayModel& model, std::span<const Vec2> directions,
           std::span<const double> ranges);
  /// Says what those beams do that met something and end well within the box, but for what is
  /// filled of them, and sets their kind to kSilent. Gives what they say of the sensor's own cell.
  float draw(const BeamTable& table, const RayFrame& frame, ScanNotes::Writer out);

  void resize(std::size_t rays);
};

}  // namespace eyebridge::mapping
