#include "pnm.hpp"

#include <algorithm>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/read_file.hpp"
#include "eyebridge/base/write_file.hpp"

namespace eyebridge::robios {
namespace {

constexpr std::uintmax_t kLargestFile = 256u << 20;

/// As a caller is told it, who does not say the name himself.
Error in_file(const Error& error, const std::filesystem::path& path) {
  return {error.code, path.string() + ": " + error.what};
}

}  // namespace

Result<PnmPicture> read_pnm_file(const std::filesystem::path& path) {
  const auto bytes = read_file(path, kLargestFile);
  if (!bytes) return tl::unexpected(in_file(bytes.error(), path));
  try {
    return read_pnm(*bytes, path.string());
  } catch (const ConfigError& error) {
    return fail(Errc::Corrupt, error.what());
  }
}

std::vector<std::uint8_t> write_pnm(const PnmPicture& image) {
  const char form = image.kind == PnmKind::Bitmap ? '4' : image.kind == PnmKind::Grey ? '5' : '6';
  std::string header = std::string("P") + form + "\n" + std::to_string(image.columns) + " " +
                       std::to_string(image.rows) + "\n";
  if (image.kind != PnmKind::Bitmap) {
    header += "255\n";
  }
  std::vector<std::uint8_t> out(header.begin(), header.end());
  if (image.kind != PnmKind::Bitmap) {
    out.insert(out.end(), image.bytes.begin(), image.bytes.end());
    return out;
  }
  const auto width = static_cast<std::size_t>(image.columns);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) {
    const std::size_t x = i % width;
    if (x % 8 == 0) {
      out.push_back(0);
    }
    if (image.bytes[i] != 0) {
      out.back() = static_cast<std::uint8_t>(out.back() | (0x80u >> (x % 8)));
    }
  }
  return out;
}

Result<void> write_pnm_file(const PnmPicture& image, const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = write_pnm(image);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are char to files
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return write_file(path, text).map_error([&](const Error& error) { return in_file(error, path); });
}

void fit(const PnmPicture& image, ImageSize size, Bytes out) {
  const std::size_t channels = pnm_channels(image.kind);
  const std::size_t row = static_cast<std::size_t>(size.width) * channels;
  const std::size_t from_row = static_cast<std::size_t>(image.columns) * channels;
  const std::size_t copied = std::min(row, from_row);
  std::fill_n(out.begin(), row * static_cast<std::size_t>(size.height), std::uint8_t{0});
  for (std::size_t y = 0; y < static_cast<std::size_t>(std::min(size.height, image.rows)); ++y) {
    std::copy_n(image.bytes.begin() + static_cast<std::ptrdiff_t>(y * from_row), copied,
                out.begin() + static_cast<std::ptrdiff_t>(y * row));
  }
}

}  // namespace eyebridge::robios
