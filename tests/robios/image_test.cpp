#include "image.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace eyebridge::robios {
namespace {

using Image = std::vector<std::uint8_t>;

TEST(Colour, GreyIsTheIntegerMean) {
  EXPECT_EQ(grey_of({255, 0, 0}), 85);
  EXPECT_EQ(grey_of({1, 1, 0}), 0);
  EXPECT_EQ(grey_of({255, 255, 255}), 255);
  EXPECT_EQ(grey_of({10, 20, 31}), 20);
}

TEST(Colour, PureColoursHaveTheHuesOfTheirChannels) {
  EXPECT_EQ(hue_of({255, 0, 0}), 43);
  EXPECT_EQ(hue_of({0, 255, 0}), 128);
  EXPECT_EQ(hue_of({0, 0, 255}), 213);
}

TEST(Colour, MixedColoursLieBetween) {
  EXPECT_EQ(hue_of({255, 255, 0}), 85);   // 43 + 42 * 255 / 255
  EXPECT_EQ(hue_of({255, 0, 255}), 1);    // 43 - 42
  EXPECT_EQ(hue_of({0, 255, 255}), 170);  // 128 + 42
  EXPECT_EQ(hue_of({200, 100, 0}), 64);   // 43 + 42 * 100 / 200
  EXPECT_EQ(hue_of({0, 90, 200}), 195);   // 213 + 42 * (0 - 90) / 200 = 213 - 18
}

TEST(Colour, PaleAndDarkColoursHaveNoHue) {
  EXPECT_EQ(hue_of({200, 100, 100}), 0);  // 2 * 100 is not more than 200
  EXPECT_NE(hue_of({200, 99, 99}), 0);
  EXPECT_EQ(hue_of({32, 0, 0}), 0);  // intensity 10
  EXPECT_EQ(hue_of({33, 0, 0}), 43);
  EXPECT_EQ(hue_of({0, 0, 0}), 0);
}

TEST(Colour, SaturationFallsWithTheWeakestChannel) {
  EXPECT_EQ(hsi_of({255, 0, 0}), (Hsi{43, 255, 85}));
  EXPECT_EQ(hsi_of({100, 100, 100}), (Hsi{0, 0, 100}));
  EXPECT_EQ(hsi_of({0, 0, 0}), (Hsi{0, 0, 0}));
  EXPECT_EQ(hsi_of({90, 30, 60}), (Hsi{22, 128, 60}));  // 43 + 42 * (30 - 60) / 60; 255 - 127
}

TEST(Laplace, IsFourTimesTheCentreLessItsNeighbours) {
  const Image in{0, 10, 0, 20, 50, 30, 0, 40, 0};
  Image out(9, 7);
  laplace({3, 3}, in, out);
  EXPECT_EQ(out, (Image{7, 7, 7, 7, 100, 7, 7, 7, 7}));  // 200 - 10 - 20 - 30 - 40
}

TEST(Laplace, TakesTheMagnitudeAndStopsAt255) {
  const Image dark{0, 50, 0, 50, 0, 50, 0, 50, 0};
  Image out(9, 0);
  laplace({3, 3}, dark, out);
  EXPECT_EQ(out[4], 200);
  const Image bright{0, 0, 0, 0, 100, 0, 0, 0, 0};
  laplace({3, 3}, bright, out);
  EXPECT_EQ(out[4], 255);
}

TEST(Sobel, IsAThirdOfBothGradients) {
  const Image in{10, 20, 30, 40, 99, 60, 70, 80, 90};
  // Gx = 30 + 120 + 90 - 10 - 80 - 70 = 80, Gy = 70 + 160 + 90 - 10 - 40 - 30 = 240
  Image out(9, 7);
  sobel({3, 3}, in, out);
  EXPECT_EQ(out, (Image{0, 0, 0, 7, 106, 7, 0, 0, 0}));
}

TEST(Sobel, StopsAt255) {
  const Image in{0, 0, 255, 0, 0, 255, 0, 0, 255};  // Gx = 1020, Gy = 0
  Image out(9, 7);
  sobel({3, 3}, in, out);
  EXPECT_EQ(out[4], 255);
}

TEST(Filters, LeaveImagesWithoutInnerPixelsInPeace) {
  const Image in{1, 2};
  Image out{9, 9};
  laplace({2, 1}, in, out);
  EXPECT_EQ(out, (Image{9, 9}));
  sobel({2, 1}, in, out);
  EXPECT_EQ(out, (Image{0, 0}));
}

TEST(Conversion, GreyToColourAndBackIsTheIdentity) {
  const Image grey{0, 1, 128, 255};
  Image colour(12);
  Image back(4);
  grey_to_colour({4, 1}, grey, colour);
  EXPECT_EQ(colour, (Image{0, 0, 0, 1, 1, 1, 128, 128, 128, 255, 255, 255}));
  colour_to_grey({4, 1}, colour, back);
  EXPECT_EQ(back, grey);
}

TEST(Conversion, PlanesAreWovenIntoPixels) {
  Image colour(6);
  planes_to_colour({2, 1}, Image{1, 2}, Image{3, 4}, Image{5, 6}, colour);
  EXPECT_EQ(colour, (Image{1, 3, 5, 2, 4, 6}));
}

TEST(Conversion, HsiPlanesHoldWhatEachPixelHas) {
  Image h(2);
  Image s(2);
  Image i(2);
  colour_to_hsi({2, 1}, Image{255, 0, 0, 100, 100, 100}, h, s, i);
  EXPECT_EQ(h, (Image{43, 0}));
  EXPECT_EQ(s, (Image{255, 0}));
  EXPECT_EQ(i, (Image{85, 100}));
}

TEST(Overlay, BlackIsTransparent) {
  Image out(6);
  overlay({2, 1}, Image{1, 2, 3, 4, 5, 6}, Image{0, 0, 0, 0, 9, 0}, out);
  EXPECT_EQ(out, (Image{1, 2, 3, 0, 9, 0}));
}

TEST(Overlay, PaintsWhereTheMaskIsSet) {
  Image out(6);
  overlay_grey({2, 1}, Image{50, 60}, Image{0, 1}, {255, 128, 0}, out);
  EXPECT_EQ(out, (Image{50, 50, 50, 255, 128, 0}));
}

}  // namespace
}  // namespace eyebridge::robios
