#include "vision/dictionary.hpp"

#include <stdexcept>
#include <string>

namespace eyebridge::camera {

const cv::Ptr<cv::aruco::Dictionary>& dictionary() {
  static const auto kDictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_1000);
  return kDictionary;
}

FiducialBits bits_of(int id) {
  if (id < 0 || id >= kFiducials) {
    throw std::out_of_range("no fiducial " + std::to_string(id) + ", expected 0 to " +
                            std::to_string(kFiducials - 1));
  }
  constexpr int kCode = kFiducialCells - 2;
  const cv::Mat code =
      cv::aruco::Dictionary::getBitsFromByteList(dictionary()->bytesList.row(id), kCode);
  FiducialBits bits{};
  for (int row = 0; row < kCode; ++row) {
    for (int column = 0; column < kCode; ++column) {
      bits[static_cast<std::size_t>((row + 1) * kFiducialCells + column + 1)] =
          code.at<std::uint8_t>(row, column);
    }
  }
  return bits;
}

}  // namespace eyebridge::camera
