#pragma once

#include <cstdint>
#include <span>

#include "eyebridge/base/colour.hpp"

namespace eyebridge::robios {

/// Width and height of an image in pixels, both at least 1.
struct ImageSize {
  int width = 0;
  int height = 0;

  [[nodiscard]] constexpr std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

using ConstBytes = std::span<const std::uint8_t>;
using Bytes = std::span<std::uint8_t>;

// Images are rows of bytes, top-left first: one byte a pixel when grey, R, G, B when in colour. A
// span holds at least the whole image. All functions are pure: any thread.

/// Hue, saturation and intensity, each in a byte.
struct Hsi {
  std::uint8_t hue = 0;  ///< 1..255: red 43, green 128, blue 213; 0 is grey.
  std::uint8_t saturation = 0;
  std::uint8_t intensity = 0;

  friend constexpr bool operator==(Hsi, Hsi) = default;
};

/// Integer mean of the three channels.
std::uint8_t grey_of(Rgb colour);
/// 0 unless 2 (max - min) > max and intensity > 10; else the centre of the strongest channel (red
/// before green before blue) plus 42 (difference of the two others) / (max - min), towards zero.
std::uint8_t hue_of(Rgb colour);
/// Saturation is 255 - 255 min / intensity, 0 for black; intensity is grey_of().
Hsi hsi_of(Rgb colour);

/// |4 centre - north - south - east - west|, at most 255. The outermost pixels of `out` are left as
/// they are. `in` and `out` do not overlap.
void laplace(ImageSize size, ConstBytes in, Bytes out);
/// (|Gx| + |Gy|) / 3, at most 255, with the 3 x 3 masks 1 2 1. First and last row 0, first and last
/// column left as they are. `in` and `out` do not overlap.
void sobel(ImageSize size, ConstBytes in, Bytes out);

void colour_to_grey(ImageSize size, ConstBytes colour, Bytes grey);
void grey_to_colour(ImageSize size, ConstBytes grey, Bytes colour);
/// Three planes to one colour image.
void planes_to_colour(ImageSize size, ConstBytes red, ConstBytes green, ConstBytes blue,
                      Bytes colour);
/// A colour image to three planes.
void colour_to_hsi(ImageSize size, ConstBytes colour, Bytes hue, Bytes saturation, Bytes intensity);
/// `below` where `above` is black (0, 0, 0), else `above`; all in colour.
void overlay(ImageSize size, ConstBytes below, ConstBytes above, Bytes out);
/// `below` as colour where `mask` is 0, else `paint`; `out` is in colour.
void overlay_grey(ImageSize size, ConstBytes below, ConstBytes mask, Rgb paint, Bytes out);

}  // namespace eyebridge::robios
