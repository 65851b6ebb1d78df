#include "album.hpp"

#include <QLibraryInfo>
#include <QString>
#include <QVersionNumber>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace eyebridge::gui::testing {
namespace {

constexpr int kLeastDifference = 48;  // of 255, in one of the colours
constexpr int kOneOf = 200;           // pixels may differ by more

bool differ(QRgb a, QRgb b) {
  return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)),
                   std::abs(qBlue(a) - qBlue(b))}) > kLeastDifference;
}

int different_pixels(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) count += differ(a.pixel(x, y), b.pixel(x, y)) ? 1 : 0;
  }
  return count;
}

/// Qt's own parts (titles of docks, say) are of other sizes in some of its versions, which then
/// have pictures of their own.
std::filesystem::path own_picture_of(const std::string& name) {
  std::filesystem::path pictures = EYEBRIDGE_SOURCE_DIR "/tests/gui/pictures";
  const QVersionNumber qt = QLibraryInfo::version();
  const QVersionNumber minor(qt.majorVersion(), qt.minorVersion());
  const QVersionNumber usual(6, 4);  // of Debian 12, with which the pictures were made
  if (minor != usual) pictures /= "qt-" + minor.toString().toStdString();
  return pictures / (name + ".png");
}

std::filesystem::path picture_of(const std::string& name) {
  const auto own = own_picture_of(name);
  return std::filesystem::exists(own)
             ? own
             : std::filesystem::path(EYEBRIDGE_SOURCE_DIR "/tests/gui/pictures/" + name + ".png");
}

bool save(const QImage& picture, const std::filesystem::path& path) {
  std::filesystem::create_directories(path.parent_path());
  return picture.save(QString::fromStdString(path.string()));
}

}  // namespace

::testing::AssertionResult looks_as(const QImage& seen, const std::string& name) {
  const std::filesystem::path root = EYEBRIDGE_SOURCE_DIR;
  const auto reference = picture_of(name);
  if (std::getenv("EYEBRIDGE_TEST_ACCEPT") != nullptr) {
    const auto own = own_picture_of(name);
    if (save(seen, own)) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << own << " cannot be written";
  }
  const QImage expected(QString::fromStdString(reference.string()));
  const auto differs = [&](const std::string& how) {
    const auto place = root / "build/gui" / (name + ".png");
    save(seen, place);
    return ::testing::AssertionFailure()
           << "not as " << reference << ": " << how << "; seen: " << place;
  };
  if (expected.isNull()) return differs("there is no such picture");
  if (expected.size() != seen.size()) {
    return differs("its size is " + std::to_string(seen.width()) + " x " +
                   std::to_string(seen.height()));
  }
  const int different = different_pixels(seen, expected);
  if (different * kOneOf > seen.width() * seen.height()) {
    return differs(std::to_string(different) + " pixels differ");
  }
  return ::testing::AssertionSuccess();
}

}  // namespace eyebridge::gui::testing
