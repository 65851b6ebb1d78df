#include <array>
#include <string>

#include "convert.hpp"
#include "globals.hpp"
#include "guarded.hpp"
#include "image.hpp"
#include "pnm.hpp"
#include <eyebot.h>

using eyebridge::Errc;
using eyebridge::fail;
using eyebridge::PnmKind;
using eyebridge::PnmPicture;
using eyebridge::Result;
using eyebridge::Rgb;
using eyebridge::robios::Bytes;
using eyebridge::robios::Call;
using eyebridge::robios::ConstBytes;
using eyebridge::robios::guarded;
using eyebridge::robios::ImageSize;
using eyebridge::robios::Session;
using eyebridge::robios::to_rgb;

int IP_WIDTH = QVGA_X;
int IP_HEIGHT = QVGA_Y;
int IP_PIXELS = QVGA_PIXELS;
int IP_SIZE = QVGA_SIZE;

void eyebridge::robios::set_ip_size(ImageSize size) {
  EYEBRIDGE_VARIABLE(IP_WIDTH) = size.width;
  EYEBRIDGE_VARIABLE(IP_HEIGHT) = size.height;
  EYEBRIDGE_VARIABLE(IP_PIXELS) = size.width * size.height;
  EYEBRIDGE_VARIABLE(IP_SIZE) = 3 * size.width * size.height;
}

namespace {

constexpr std::array<ImageSize, 6> kIpModes{{{QQVGA_X, QQVGA_Y},
                                             {QVGA_X, QVGA_Y},
                                             {VGA_X, VGA_Y},
                                             {CAM1MP_X, CAM1MP_Y},
                                             {CAMHD_X, CAMHD_Y},
                                             {CAM5MP_X, CAM5MP_Y}}};

/// The image that a call works on, and its planes as spans of that size.
struct Image {
  ImageSize size;

  [[nodiscard]] ConstBytes grey(const BYTE* data) const { return {data, size.pixels()}; }
  [[nodiscard]] Bytes grey(BYTE* data) const { return {data, size.pixels()}; }
  [[nodiscard]] ConstBytes colour(const BYTE* data) const { return {data, 3 * size.pixels()}; }
  [[nodiscard]] Bytes colour(BYTE* data) const { return {data, 3 * size.pixels()}; }
};

/// Runs `work` on the current size when none of the images is null. Returns 0, or `failure`.
template <class Work, class... Pointers>
int processing(const Call& call, int failure, Work&& work, const Pointers*... images) {
  return guarded(call, failure, [&](Session&) -> Result<int> {
    if ((... || (images == nullptr))) {
      return eyebridge::robios::null_pointer();
    }
    const int width = EYEBRIDGE_VARIABLE(IP_WIDTH);
    const int height = EYEBRIDGE_VARIABLE(IP_HEIGHT);
    const Image image{{width, height}};
    if (image.size.width < 1 || image.size.height < 1) {
      return fail(Errc::OutOfRange, "IP_WIDTH or IP_HEIGHT was overwritten with " +
                                        std::to_string(width) + " x " + std::to_string(height));
    }
    return work(image);
  });
}

/// The same for calls that cannot fail otherwise.
template <class Work, class... Pointers>
void filtering(const Call& call, Work&& work, const Pointers*... images) {
  processing(
      call, 1,
      [&](const Image& image) -> Result<int> {
        work(image);
        return 0;
      },
      images...);
}

Result<int> write(const char* filename, PnmKind kind, const Image& image, ConstBytes bytes) {
  const PnmPicture file{kind, image.size.width, image.size.height, {bytes.begin(), bytes.end()}};
  return eyebridge::robios::write_pnm_file(file, filename).map([] { return 0; });
}

void store(BYTE* where, std::uint8_t value) {
  if (where != nullptr) {
    *where = value;
  }
}

}  // namespace

int IPSetSize(int resolution) {
  return guarded("IPSetSize", 1, [&](Session&) -> Result<int> {
    if (resolution < 0 || resolution >= static_cast<int>(kIpModes.size())) {
      return fail(Errc::OutOfRange, "image mode " + std::to_string(resolution) + ", expected 0..5");
    }
    eyebridge::robios::set_ip_size(kIpModes.at(static_cast<std::size_t>(resolution)));
    return 0;
  });
}

int IPReadFile(const char* filename, BYTE* img) {
  return processing(
      "IPReadFile", -1,
      [&](const Image& image) -> Result<int> {
        return eyebridge::robios::read_pnm_file(filename).map([&](const PnmPicture& file) {
          eyebridge::robios::fit(file, image.size, image.colour(img));
          return file.kind == PnmKind::Colour ? 3 : file.kind == PnmKind::Grey ? 2 : 1;
        });
      },
      filename, img);
}

int IPWriteFile(const char* filename, BYTE* img) {
  return processing(
      "IPWriteFile", 1,
      [&](const Image& image) {
        return write(filename, PnmKind::Colour, image, image.colour(img));
      },
      filename, img);
}

int IPWriteFileGray(const char* filename, BYTE* gray) {
  return processing(
      "IPWriteFileGray", 1,
      [&](const Image& image) { return write(filename, PnmKind::Grey, image, image.grey(gray)); },
      filename, gray);
}

void IPLaplace(BYTE* grayIn, BYTE* grayOut) {
  filtering(
      "IPLaplace",
      [&](const Image& image) {
        eyebridge::robios::laplace(image.size, image.grey(grayIn), image.grey(grayOut));
      },
      grayIn, grayOut);
}

void IPSobel(BYTE* grayIn, BYTE* grayOut) {
  filtering(
      "IPSobel",
      [&](const Image& image) {
        eyebridge::robios::sobel(image.size, image.grey(grayIn), image.grey(grayOut));
      },
      grayIn, grayOut);
}

void IPCol2Gray(BYTE* imgIn, BYTE* grayOut) {
  filtering(
      "IPCol2Gray",
      [&](const Image& image) {
        eyebridge::robios::colour_to_grey(image.size, image.colour(imgIn), image.grey(grayOut));
      },
      imgIn, grayOut);
}

void IPGray2Col(BYTE* imgIn, BYTE* colOut) {
  filtering(
      "IPGray2Col",
      [&](const Image& image) {
        eyebridge::robios::grey_to_colour(image.size, image.grey(imgIn), image.colour(colOut));
      },
      imgIn, colOut);
}

void IPRGB2Col(BYTE* r, BYTE* g, BYTE* b, BYTE* imgOut) {
  filtering(
      "IPRGB2Col",
      [&](const Image& image) {
        eyebridge::robios::planes_to_colour(image.size, image.grey(r), image.grey(g), image.grey(b),
                                            image.colour(imgOut));
      },
      r, g, b, imgOut);
}

void IPCol2HSI(BYTE* img, BYTE* h, BYTE* s, BYTE* i) {
  filtering(
      "IPCol2HSI",
      [&](const Image& image) {
        eyebridge::robios::colour_to_hsi(image.size, image.colour(img), image.grey(h),
                                         image.grey(s), image.grey(i));
      },
      img, h, s, i);
}

void IPOverlay(BYTE* c1, BYTE* c2, BYTE* cOut) {
  filtering(
      "IPOverlay",
      [&](const Image& image) {
        eyebridge::robios::overlay(image.size, image.colour(c1), image.colour(c2),
                                   image.colour(cOut));
      },
      c1, c2, cOut);
}

void IPOverlayGray(BYTE* g1, BYTE* g2, COLOR col, BYTE* cOut) {
  filtering(
      "IPOverlayGray",
      [&](const Image& image) {
        eyebridge::robios::overlay_grey(image.size, image.grey(g1), image.grey(g2), to_rgb(col),
                                        image.colour(cOut));
      },
      g1, g2, cOut);
}

// A pixel at a time, called a hundred thousand times a frame: these neither fail nor cost time.

COLOR IPPRGB2Col(BYTE r, BYTE g, BYTE b) { return r << 16 | g << 8 | b; }

void IPPCol2RGB(COLOR col, BYTE* r, BYTE* g, BYTE* b) {
  const Rgb colour = to_rgb(col);
  store(r, colour.r);
  store(g, colour.g);
  store(b, colour.b);
}

void IPPCol2HSI(COLOR c, BYTE* h, BYTE* s, BYTE* i) {
  const Rgb colour = to_rgb(c);
  IPPRGB2HSI(colour.r, colour.g, colour.b, h, s, i);
}

BYTE IPPRGB2Hue(BYTE r, BYTE g, BYTE b) { return eyebridge::robios::hue_of({r, g, b}); }

void IPPRGB2HSI(BYTE r, BYTE g, BYTE b, BYTE* h, BYTE* s, BYTE* i) {
  const eyebridge::robios::Hsi hsi = eyebridge::robios::hsi_of({r, g, b});
  store(h, hsi.hue);
  store(s, hsi.saturation);
  store(i, hsi.intensity);
}
