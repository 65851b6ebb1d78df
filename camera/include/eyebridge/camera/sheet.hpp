#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "eyebridge/camera/calibrator.hpp"
#include "eyebridge/camera/fiducials.hpp"
#include "eyebridge/camera/frame.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::camera {

/// Largest fiducial that fits on A4 paper with its margin, metres.
inline constexpr double kLargestPrinted = 0.147;

/// Of a page that is shown on a screen: about 150 dpi.
inline constexpr double kPixelsPerMm = 6.0;

/// What to print, cut out and stick on the walls of a world: a map with the number of each
/// fiducial, then all of them true to size with their places. A4. Lent for the call.
struct FiducialSheet {
  const world::WorldModel& model;
  std::span<const Fiducial> fiducials;  ///< Of place_fiducials().
  std::string title;                    ///< Of the world.
};

/// Number of pages, the map included.
int pages_of(const FiducialSheet& sheet);

/// Writes a PDF. Throws ConfigError when a fiducial is larger than kLargestPrinted or the vision
/// library is missing, std::runtime_error naming the file and the reason.
void write_pdf(const FiducialSheet& sheet, const std::filesystem::path& path);

/// Page `page`, 1 … pages_of(), as Rgb24 with so many pixels a millimetre. Throws likewise, and
/// std::out_of_range for another page.
Frame draw_page(const FiducialSheet& sheet, int page, double pixels_per_mm);

/// A board to print and stick on something flat, A4. Throws ConfigError when it does not fit,
/// std::runtime_error naming the file and the reason.
void write_pdf(const Board& board, const std::filesystem::path& path);
Frame draw_page(const Board& board, double pixels_per_mm);

}  // namespace eyebridge::camera
