#include <algorithm>
#include <utility>

#include "eyebridge/base/pnm.hpp"
#include "eyebridge/files/map_files.hpp"
#include "stb_picture.hpp"

namespace eyebridge::files {
namespace {

GreyPicture grey_of(PnmPicture picture) {
  GreyPicture grey{picture.columns, picture.rows, {}};
  switch (picture.kind) {
    case PnmKind::Grey:
      grey.greys = std::move(picture.bytes);
      break;
    case PnmKind::Bitmap:
      grey.greys.reserve(picture.bytes.size());
      for (const std::uint8_t black : picture.bytes) grey.greys.push_back(black != 0 ? 0 : 255);
      break;
    case PnmKind::Colour:  // as map_server: the mean
      grey.greys.reserve(picture.bytes.size() / 3);
      for (std::size_t i = 0; i < picture.bytes.size(); i += 3) {
        const int sum = picture.bytes[i] + picture.bytes[i + 1] + picture.bytes[i + 2];
        grey.greys.push_back(static_cast<std::uint8_t>(sum / 3));
      }
      break;
  }
  return grey;
}

}  // namespace

GreyPicture read_map_picture(std::string_view bytes, const std::string& file) {
  if (bytes.starts_with("\x89PNG") || bytes.starts_with("BM")) {
    return read_stb_picture(bytes, file, mapping::kMostMapCells);
  }
  if (bytes.size() < 2 || bytes[0] != 'P' || bytes[1] < '1' || bytes[1] > '6') {
    throw ConfigError({file, 0, 0}, "no picture that a map can have: expected PGM, PNG or BMP");
  }
  return grey_of(read_pnm(bytes, file, mapping::kMostMapCells));
}

}  // namespace eyebridge::files
