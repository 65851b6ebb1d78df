#include <utility>

#include "eyebridge/base/pnm.hpp"
#include "eyebridge/files/map_files.hpp"

namespace eyebridge::files {

GreyPicture read_map_picture(std::string_view bytes, const std::string& file) {
  PnmPicture picture = read_pnm(bytes, file, mapping::kMostMapCells);
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

}  // namespace eyebridge::files
