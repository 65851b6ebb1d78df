#include "image.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace eyebridge::robios {
namespace {

std::uint8_t clipped(int value) { return static_cast<std::uint8_t>(std::min(value, 255)); }

Rgb pixel(ConstBytes colour, std::size_t i) {
  return {colour[3 * i], colour[3 * i + 1], colour[3 * i + 2]};
}

void set_pixel(Bytes colour, std::size_t i, Rgb value) {
  colour[3 * i] = value.r;
  colour[3 * i + 1] = value.g;
  colour[3 * i + 2] = value.b;
}

}  // namespace

std::uint8_t grey_of(Rgb colour) {
  return static_cast<std::uint8_t>((colour.r + colour.g + colour.b) / 3);
}

std::uint8_t hue_of(Rgb colour) {
  const int r = colour.r;
  const int g = colour.g;
  const int b = colour.b;
  const int strongest = std::max({r, g, b});
  const int spread = strongest - std::min({r, g, b});
  if (2 * spread <= strongest || grey_of(colour) <= 10) {
    return 0;
  }
  if (r == strongest) {
    return static_cast<std::uint8_t>(43 + 42 * (g - b) / spread);
  }
  if (g == strongest) {
    return static_cast<std::uint8_t>(128 + 42 * (b - r) / spread);
  }
  return static_cast<std::uint8_t>(213 + 42 * (r - g) / spread);
}

Hsi hsi_of(Rgb colour) {
  const std::uint8_t intensity = grey_of(colour);
  const int weakest = std::min({colour.r, colour.g, colour.b});
  const int saturation = intensity == 0 ? 0 : 255 - 255 * weakest / intensity;
  return {hue_of(colour), static_cast<std::uint8_t>(saturation), intensity};
}

void laplace(ImageSize size, ConstBytes in, Bytes out) {
  assert(in.size() >= size.pixels() && out.size() >= size.pixels());
  const auto width = static_cast<std::size_t>(size.width);
  const auto height = static_cast<std::size_t>(size.height);
  for (std::size_t y = 1; y + 1 < height; ++y) {
    for (std::size_t i = y * width + 1; i + 1 < (y + 1) * width; ++i) {
      out[i] = clipped(std::abs(4 * in[i] - in[i - width] - in[i + width] - in[i - 1] - in[i + 1]));
    }
  }
}

void sobel(ImageSize size, ConstBytes in, Bytes out) {
  assert(in.size() >= size.pixels() && out.size() >= size.pixels());
  const auto width = static_cast<std::size_t>(size.width);
  const auto height = static_cast<std::size_t>(size.height);
  for (std::size_t y = 1; y + 1 < height; ++y) {
    for (std::size_t i = y * width + 1; i + 1 < (y + 1) * width; ++i) {
      const std::size_t above = i - width;
      const std::size_t below = i + width;
      const int gx = in[above + 1] + 2 * in[i + 1] + in[below + 1] - in[above - 1] - 2 * in[i - 1] -
                     in[below - 1];
      const int gy = in[below - 1] + 2 * in[below] + in[below + 1] - in[above - 1] - 2 * in[above] -
                     in[above + 1];
      out[i] = clipped((std::abs(gx) + std::abs(gy)) / 3);
    }
  }
  std::fill_n(out.begin(), width, std::uint8_t{0});
  std::fill_n(out.begin() + static_cast<std::ptrdiff_t>((height - 1) * width), width,
              std::uint8_t{0});
}

void colour_to_grey(ImageSize size, ConstBytes colour, Bytes grey) {
  assert(colour.size() >= 3 * size.pixels() && grey.size() >= size.pixels());
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    grey[i] = grey_of(pixel(colour, i));
  }
}

void grey_to_colour(ImageSize size, ConstBytes grey, Bytes colour) {
  assert(grey.size() >= size.pixels() && colour.size() >= 3 * size.pixels());
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    set_pixel(colour, i, {grey[i], grey[i], grey[i]});
  }
}

void planes_to_colour(ImageSize size, ConstBytes red, ConstBytes green, ConstBytes blue,
                      Bytes colour) {
  assert(colour.size() >= 3 * size.pixels());
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    set_pixel(colour, i, {red[i], green[i], blue[i]});
  }
}

void colour_to_hsi(ImageSize size, ConstBytes colour, Bytes hue, Bytes saturation,
                   Bytes intensity) {
  assert(colour.size() >= 3 * size.pixels());
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    const Hsi hsi = hsi_of(pixel(colour, i));
    hue[i] = hsi.hue;
    saturation[i] = hsi.saturation;
    intensity[i] = hsi.intensity;
  }
}

void overlay(ImageSize size, ConstBytes below, ConstBytes above, Bytes out) {
  assert(out.size() >= 3 * size.pixels());
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    const Rgb top = pixel(above, i);
    set_pixel(out, i, top == Rgb{} ? pixel(below, i) : top);
  }
}

void overlay_grey(ImageSize size, ConstBytes below, ConstBytes mask, Rgb paint, Bytes out) {
  assert(out.size() >= 3 * size.pixels());
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    set_pixel(out, i, mask[i] == 0 ? Rgb{below[i], below[i], below[i]} : paint);
  }
}

}  // namespace eyebridge::robios
