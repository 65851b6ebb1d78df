// Image processing, on images of 82 x 62.

#include <cstdint>
#include <cstdlib>

#include "call.hpp"
#include "eyebot.h"
#include "image.hpp"
#include "mono_lcd.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::doing;

constexpr robios::ImageSize kImage{imagecolumns, imagerows};

robios::Bytes bytes_of(image* img) { return {&(*img)[0][0], kImage.pixels()}; }

/// Runs `work` unless a pointer is null or the result would overwrite what is still to be read.
template <class Work, class Source>
int filtering(const robios::Call& name, Source* src, image* dest, Work&& work) {
  return doing(name, 1, [&](Session&) -> Result<void> {
    if (src == nullptr || dest == nullptr) return robios::null_pointer();
    if (static_cast<void*>(src) == static_cast<void*>(dest)) {
      return fail(Errc::OutOfRange, "source and destination are the same image");
    }
    work();
    return {};
  });
}

}  // namespace

int IPLaplace(image* src, image* dest) {
  return filtering("IPLaplace", src, dest,
                   [&] { robios::laplace(kImage, bytes_of(src), bytes_of(dest)); });
}

int IPSobel(image* src, image* dest) {
  return filtering("IPSobel", src, dest,
                   [&] { robios::sobel(kImage, bytes_of(src), bytes_of(dest)); });
}

int IPDither(image* src, image* dest) {
  return filtering("IPDither", src, dest, [&] {
    for (int y = 0; y < imagerows; ++y) {
      for (int x = 0; x < imagecolumns; ++x) {
        // The pattern of LCDPutGraphic(), which leaves the border out.
        const bool white = robios::is_white(x - 1, y - 1, (*src)[y][x]);
        (*dest)[y][x] = white ? 255 : 0;
      }
    }
  });
}

int IPDiffer(image* current, image* last, image* dest) {
  // Without the last image there is no difference to tell of.
  return filtering("IPDiffer", last == nullptr ? nullptr : current, dest, [&] {
    for (int y = 0; y < imagerows; ++y) {
      for (int x = 0; x < imagecolumns; ++x) {
        (*dest)[y][x] = static_cast<std::uint8_t>(std::abs((*current)[y][x] - (*last)[y][x]));
      }
    }
  });
}

int IPColor2Grey(colimage* src, image* dest) {
  return filtering("IPColor2Grey", src, dest, [&] {
    robios::colour_to_grey(kImage, {&(*src)[0][0][0], 3 * kImage.pixels()}, bytes_of(dest));
  });
}
