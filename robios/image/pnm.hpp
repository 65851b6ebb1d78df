#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/base/pnm.hpp"
#include "eyebridge/base/result.hpp"
#include "image.hpp"

namespace eyebridge::robios {

/// Reads a file of at most 256 MB by read_pnm(). Fails with Unsupported when it cannot be read,
/// with Corrupt when it is no picture.
Result<PnmPicture> read_pnm_file(const std::filesystem::path& path);

/// The image as a binary file: P4, P5 or P6. Pure.
std::vector<std::uint8_t> write_pnm(const PnmPicture& image);
/// write_pnm() to a file. Fails with Unsupported, naming the file and the reason.
Result<void> write_pnm_file(const PnmPicture& image, const std::filesystem::path& path);

/// Copies `image` to one of `size` pixels and the same kind, top-left aligned: what is missing is
/// 0, what is too much is cut off. `out` holds size.pixels() * pnm_channels(kind) bytes.
void fit(const PnmPicture& image, ImageSize size, Bytes out);

}  // namespace eyebridge::robios
